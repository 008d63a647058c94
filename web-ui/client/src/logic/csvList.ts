// A list of a scenario (orders, holidays, ...) as a table: saved as CSV, and read from one that a spreadsheet wrote.

import type { JsonSchema } from '../types';
import { parseNumber } from './fields';
import type { Json } from './pointer';
import { meaningAndUnit, resolve } from './schema';

/** Words for what is wrong with a table: a key of the dictionary "form.csv.KEY" and what stands in it. */
export class TableError extends Error {
  constructor(
    readonly key: 'empty' | 'columns' | 'twice' | 'missing' | 'cells' | 'number' | 'integer' | 'choice',
    readonly values: Record<string, string | number> = {},
  ) {
    super(`${key}: ${JSON.stringify(values)}`);
  }
}

const scalar = (schema: JsonSchema) => schema.type === 'number' || schema.type === 'integer' || schema.type === 'string' || schema.type === 'boolean';

/** Members of the list's entries when all of them are single values, so that a row of a table can hold them; else null. */
export function columnsOf(root: JsonSchema, items: JsonSchema): { name: string; schema: JsonSchema; required: boolean }[] | null {
  const item = resolve(root, items);
  if (item.type !== 'object' || item.oneOf || !item.properties) return null;
  const columns = Object.entries(item.properties).map(([name, member]) => ({ name, schema: resolve(root, member), required: item.required?.includes(name) ?? false }));
  return columns.length > 0 && columns.every((c) => scalar(c.schema)) ? columns : null;
}

/** Rows of cells of a CSV text: comma, semicolon or tab, whichever the header has most; quotes; a byte order mark. */
export function parseCsv(text: string): { line: number; cells: string[] }[] {
  const plain = text.replace(/^\uFEFF/, '');
  const header = plain.slice(0, plain.search(/[\r\n]|$/));
  const separator = [';', '\t', ','].reduce((best, s) => (header.split(s).length > header.split(best).length ? s : best), ';');
  const rows: { line: number; cells: string[] }[] = [];
  let cells: string[] = [];
  let cell = '';
  let [quoted, line, begun] = [false, 1, 1];
  const endRow = () => {
    cells.push(cell);
    if (cells.some((c) => c.trim() !== '')) rows.push({ line: begun, cells: cells.map((c) => c.trim()) });
    [cells, cell] = [[], ''];
  };
  for (let k = 0; k < plain.length; ++k) {
    const c = plain.charAt(k);
    if (c === '\n') ++line;
    if (quoted) {
      if (c !== '"') cell += c;
      else if (plain.charAt(k + 1) === '"') {
        cell += '"';
        ++k;
      } else quoted = false;
    } else if (c === '"' && cell.trim() === '') [quoted, cell] = [true, ''];
    else if (c === separator) {
      cells.push(cell);
      cell = '';
    } else if (c === '\n') {
      endRow();
      begun = line;
    } else if (c !== '\r') cell += c;
  }
  endRow();
  return rows;
}

/** Head row and rows of a list's entries. */
export function tableOf(columns: readonly { name: string }[], entries: readonly Json[]): (string | number | boolean | null)[][] {
  const cell = (entry: Json, name: string) => {
    const value = typeof entry === 'object' && entry !== null && !Array.isArray(entry) ? entry[name] : undefined;
    return value === undefined || typeof value === 'object' ? null : value;
  };
  return [columns.map((c) => c.name), ...entries.map((e) => columns.map((c) => cell(e, c.name)))];
}

/** A header cell without its unit, as a member's name: "Due min", "due [min]" and "due_min" are one. */
const key = (text: string) => text.toLowerCase().replace(/\[[^\]]*\]/g, '').replace(/[^\p{L}\p{N}]+/gu, '_').replace(/^_+|_+$/g, '');

/** The list that a CSV table stands for; empty cells are left out. Throws TableError. */
export function entriesOf(columns: readonly { name: string; schema: JsonSchema; required: boolean }[], text: string): Json[] {
  const [head, ...rows] = parseCsv(text);
  if (!head || rows.length === 0) throw new TableError('empty');
  const known = columns.map((c) => c.name).join(', ');
  const used = head.cells.map((cell) => {
    const wanted = key(cell);
    const column = columns.find((c) => key(c.name) === wanted) ?? columns.find((c) => { const { unit } = meaningAndUnit(c.schema); return unit !== '' && key(c.name) === `${wanted}_${key(unit)}`; });
    if (!column) throw new TableError('columns', { column: cell, known });
    return column;
  });
  used.forEach((c, k) => { if (used.indexOf(c) !== k) throw new TableError('twice', { column: c.name }); });
  const missing = columns.find((c) => c.required && !used.includes(c));
  if (missing) throw new TableError('missing', { column: missing.name });
  return rows.map(({ line, cells }) => {
    if (cells.length !== used.length) throw new TableError('cells', { line, found: cells.length, wanted: used.length });
    const entry: { [name: string]: Json } = {};
    used.forEach(({ name, schema, required }, k) => {
      const value = cells[k] ?? '';
      if (value === '' && !(required && schema.type === 'string')) {
        if (required) throw new TableError('number', { line, column: name, value });
        return;
      }
      if (schema.type === 'number' || schema.type === 'integer') {
        const number = parseNumber(value);
        if (number === null) throw new TableError('number', { line, column: name, value });
        if (schema.type === 'integer' && !Number.isSafeInteger(number)) throw new TableError('integer', { line, column: name, value });
        entry[name] = number;
      } else if (schema.type === 'boolean') {
        if (!/^(0|1|true|false)$/i.test(value)) throw new TableError('choice', { line, column: name, value, known: '0, 1' });
        entry[name] = /^(1|true)$/i.test(value);
      } else {
        if (schema.enum && !schema.enum.includes(value)) throw new TableError('choice', { line, column: name, value, known: schema.enum.join(', ') });
        // The apostrophe with which a saved table disarms formulas.
        entry[name] = /^'[=+\-@\t\r]/.test(value) ? value.slice(1) : value;
      }
    });
    return entry;
  });
}
