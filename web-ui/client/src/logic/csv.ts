// Tables for spreadsheets: the same rules as the server's CSV (RFC 4180, formulas disarmed).

export type Cell = string | number | boolean | null | undefined;

export interface CsvFormat {
  separator: ',' | ';';
  decimal: '.' | ',';
}

export function toCsv(rows: readonly (readonly Cell[])[], format: CsvFormat): string {
  const cell = (value: Cell): string => {
    let text: string;
    if (value === null || value === undefined) return '';
    if (typeof value === 'number') text = Number.isFinite(value) ? String(value).replace('.', format.decimal) : '';
    else if (typeof value === 'boolean') text = value ? '1' : '0';
    // A text that a spreadsheet would take for a formula gets an apostrophe in front.
    else text = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
    return /["\r\n]/.test(text) || text.includes(format.separator) ? `"${text.replace(/"/g, '""')}"` : text;
  };
  const body = rows.map((row) => row.map(cell).join(format.separator)).join('\r\n');
  // Excel takes a file for UTF-8 only when it begins with a byte order mark.
  return `${format.separator === ';' ? '\uFEFF' : ''}${body}\r\n`;
}

/** A file name out of a heading: letters, digits and hyphens. */
export function fileName(text: string): string {
  return (
    text
      .toLowerCase()
      .replace(/[^\p{L}\p{N}]+/gu, '-')
      .replace(/^-+|-+$/g, '')
      .slice(0, 60) || 'table'
  );
}
