import { describe, expect, it } from 'vitest';
import { toCsv } from '../src/logic/csv';
import { columnsOf, entriesOf, parseCsv, tableOf, TableError } from '../src/logic/csvList';
import type { JsonSchema } from '../src/types';
import schemaText from '../../../scenarios/scenario.schema.json?raw';

const root = JSON.parse(schemaText) as JsonSchema;
const definitions = (root as unknown as { definitions: Record<string, JsonSchema> }).definitions;
const orders = columnsOf(root, definitions['orders_2'] ?? {}) ?? [];
const wrong = (text: string): TableError => {
  try {
    entriesOf(orders, text);
  } catch (e) {
    if (e instanceof TableError) return e;
  }
  throw new Error('was taken');
};

describe('a list of a scenario as a table', () => {
  it('orders are one, tools with their strategies are none', () => {
    expect(orders.map((c) => c.name)).toContain('arrives_min');
    expect(columnsOf(root, { $ref: '#/definitions/tools' })).toBeNull();
    expect(columnsOf(root, { type: 'string' })).toBeNull();
  });
  it('comes back as it was saved, in both forms, with empty cells left out', () => {
    const list = [{ arrives_min: 0.1 + 0.2, quantity: 3, due_min: 1e6 }, { arrives_min: 480, quantity: 1 }, { arrives_min: 481.25, quantity: 20 }];
    for (const format of [{ separator: ',', decimal: '.' }, { separator: ';', decimal: ',' }] as const)
      expect(entriesOf(orders, toCsv(tableOf(orders, list), format))).toEqual(list);
  });
  it('reads what a spreadsheet writes: BOM, tabs, decimal comma, units in the header, empty lines', () => {
    const list = [{ arrives_min: 12.5, quantity: 2 }, { arrives_min: 1234.5, quantity: 4 }];
    expect(entriesOf(orders, '\uFEFFArrives [min];Quantity\r\n12,5;2\r\n;\r\n1 234,5;4\r\n')).toEqual(list);
    expect(entriesOf(orders, 'arrives min\tquantity\n12.5\t2\n1234,5\t4')).toEqual(list);
    expect(entriesOf(orders, 'arrives_min\n12,5\n')).toEqual([{ arrives_min: 12.5 }]);
  });
  it('quotes hold separators, quotes and lines', () => {
    expect(parseCsv('a;b\n"x;1";"say ""y"""\n"two\nlines";z').map((r) => [r.line, r.cells])).toEqual([[1, ['a', 'b']], [2, ['x;1', 'say "y"']], [3, ['two\nlines', 'z']]]);
  });
  it('says the line and the column of what is wrong', () => {
    expect(wrong('arrives_min;quantity\n')).toMatchObject({ key: 'empty' });
    expect(wrong('arrives_min;colour\n1;2')).toMatchObject({ key: 'columns', values: { column: 'colour' } });
    expect(wrong('arrives_min;arrives [min]\n1;2')).toMatchObject({ key: 'twice' });
    expect(wrong('quantity\n1')).toMatchObject({ key: 'missing', values: { column: 'arrives_min' } });
    expect(wrong('arrives_min;quantity\n1;2\n3\n')).toMatchObject({ key: 'cells', values: { line: 3, found: 1, wanted: 2 } });
    expect(wrong('arrives_min;quantity\n1;2\nsoon;2\n')).toMatchObject({ key: 'number', values: { line: 3, column: 'arrives_min', value: 'soon' } });
    expect(wrong('arrives_min;quantity\n1;2,5')).toMatchObject({ key: 'integer', values: { line: 2, column: 'quantity' } });
    expect(wrong('arrives_min;quantity\n1,234.5;2')).toMatchObject({ key: 'number' });
    expect(wrong('arrives_min;quantity\n;2')).toMatchObject({ key: 'number', values: { column: 'arrives_min' } });
  });
});
