// A table of the shop's own data before it is fitted: its text whatever its encoding, and its head row.

/** The first line's cells; tabs separate, else semicolons, else commas; quotes as in RFC 4180. */
export function headers(table: string): string[] {
  const line = table.replace(/^\uFEFF/, '').split(/\r\n|\n|\r/, 1)[0] ?? '';
  // "Cutting time, min" has a comma of its own: tabs and semicolons decide first.
  const separator = ['\t', ';'].find((s) => split(line, s).length > 1) ?? ',';
  return split(line, separator).map((c) => c.trim()).filter(Boolean);
}

function split(line: string, separator: string): string[] {
  const cells = [''];
  let quoted = false;
  for (let k = 0; k < line.length; ++k) {
    const c = line[k] as string;
    if (c === '"' && quoted && line[k + 1] === '"') {
      cells[cells.length - 1] += '"';
      ++k;
    } else if (c === '"') quoted = !quoted;
    else if (c === separator && !quoted) cells.push('');
    else cells[cells.length - 1] += c;
  }
  return cells;
}

/** Bytes as text: UTF-8, else Windows-1251, which never fails. */
export function decode(bytes: ArrayBuffer): { text: string; encoding: 'utf-8' | 'windows-1251' } {
  try {
    return { text: new TextDecoder('utf-8', { fatal: true }).decode(bytes), encoding: 'utf-8' };
  } catch {
    return { text: new TextDecoder('windows-1251').decode(bytes), encoding: 'windows-1251' };
  }
}

export const mostBytes = 2 * 1024 * 1024;

export type What = 'life' | 'taylor' | 'downtime' | 'arrivals' | 'cycle';
interface Form {
  /** Columns that must be there, and those that are used when they are. */
  needs: string[];
  uses: string[];
  /** Flags of `verstat fit WHAT`. */
  options: string[];
  /** Flags without a value. */
  switches?: string[];
}
/** Flags with few values; the first stands for leaving it out. */
export const choices: Record<string, string[]> = {
  decimal: ['', 'comma', 'point'],
  clock: ['', 'operating', 'calendar', 'cutting'],
  as: ['', 'law', 'profile', 'orders'],
};
/** What a pointer may look like. */
export const examples: Record<What, Record<string, string>> = {
  life: { to: '/inserts/0' },
  taylor: { to: '/inserts/0', at: '150,0.2,1' },
  downtime: { 'to-failure': '/machines/0/failures/0/time_to_failure', 'to-repair': '/machines/0/failures/0/repair', hours: '07:00-15:00', weekdays: 'mon-fri' },
  arrivals: { to: '/parts/0/supply', hours: '07:00-15:00', weekdays: 'mon-fri' },
  cycle: { to: '/operations/0/process/time' },
};
/** As `verstat fit WHAT --help` says. */
export const forms: Record<What, Form> = {
  life: { needs: ['life', 'cause'], uses: ['parts', 'tool', 'regime', 'batch', 'edge', 'last_good'], options: ['tool', 'regime', 'gamma', 'to', 'planned-cause', 'failure-cause', 'decimal'] },
  taylor: { needs: ['time', 'wear', 'speed'], uses: ['feed', 'depth', 'material', 'tool', 'laboratory', 'run', 'record'], options: ['criterion', 'material', 'tool', 'at', 'to', 'decimal'] },
  downtime: { needs: ['start', 'end'], uses: ['duration', 'machine', 'mode', 'operating', 'cutting', 'record'], options: ['mode', 'clock', 'to-failure', 'to-repair', 'hours', 'weekdays', 'decimal'], switches: ['empirical', 'accept-trend'] },
  arrivals: { needs: ['arrival'], uses: ['quantity', 'part', 'order'], options: ['part', 'as', 'to', 'hours', 'weekdays', 'decimal'], switches: ['empirical'] },
  cycle: { needs: ['cycle'], uses: ['operation', 'record'], options: ['operation', 'to', 'decimal'], switches: ['empirical'] },
};
