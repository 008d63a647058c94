import { describe, expect, it } from 'vitest';
import { alternative, findProperty, firstValue, kindOf, meaningAndUnit, rangeOf, referredList, resolve, searchBounds, title } from '../src/logic/schema';
import type { JsonSchema } from '../src/types';
import schemaText from '../../../scenarios/scenario.schema.json?raw';

// The scenario's own schema: forms must understand what the program says.
const root = JSON.parse(schemaText) as JsonSchema;

function* every(schema: JsonSchema, depth = 0): Generator<JsonSchema> {
  const here = resolve(root, schema);
  yield here;
  if (depth > 12) return;
  for (const below of [...Object.values(here.properties ?? {}), ...(here.items ? [here.items] : []), ...(here.oneOf ?? [])]) yield* every(below, depth + 1);
}

describe('the schema of scenarios', () => {
  it('has nothing that a form cannot show', () => {
    let fields = 0;
    for (const schema of every(root)) {
      ++fields;
      const known = schema.oneOf !== undefined || schema.enum !== undefined || schema.const !== undefined || ['object', 'array', 'number', 'integer', 'boolean', 'string'].includes(schema.type ?? '');
      expect(known, JSON.stringify(schema).slice(0, 200)).toBe(true);
      for (const one of schema.oneOf ?? []) expect(kindOf(resolve(root, one)), JSON.stringify(one).slice(0, 200)).not.toBe('');
    }
    expect(fields).toBeGreaterThan(300);
  });
  it('references are found by what descriptions say', () => {
    const tools = resolve(root, root.properties?.['tools'] ?? {});
    const tool = resolve(root, tools.items ?? {});
    expect(referredList(root, tool.properties?.['insert'] ?? {})).toBe('inserts');
    expect(referredList(root, tool.properties?.['crew'] ?? {})).toBe('crews');
    expect(referredList(root, { type: 'string', description: 'name of the shop' })).toBeUndefined();
    expect(referredList(root, { type: 'string', description: 'what it shows' })).toBeUndefined();
  });
  it('first values have what is required, within range', () => {
    const check = (given: JsonSchema): void => {
      const schema = resolve(root, given);
      const value = firstValue(root, schema);
      if (schema.type === 'number' || schema.type === 'integer') {
        if (typeof value !== 'number') return;
        if (schema.minimum !== undefined) expect(value).toBeGreaterThanOrEqual(schema.minimum);
        if (schema.exclusiveMinimum !== undefined) expect(value).toBeGreaterThan(schema.exclusiveMinimum);
        if (schema.maximum !== undefined) expect(value).toBeLessThanOrEqual(schema.maximum);
        if (schema.exclusiveMaximum !== undefined) expect(value).toBeLessThan(schema.exclusiveMaximum);
      }
      if (schema.type === 'object' && schema.default === undefined) for (const name of schema.required ?? []) expect(Object.keys(value as object)).toContain(name);
    };
    for (const schema of every(root)) check(schema);
  });
});

describe('reading a schema', () => {
  it('meaning and unit are told apart', () => {
    expect(meaningAndUnit({ description: 'spindle power [kW]' })).toEqual({ meaning: 'spindle power', unit: 'kW' });
    expect(meaningAndUnit({ description: 'speed [m/min] of it' })).toEqual({ meaning: 'speed [m/min] of it', unit: '' });
  });
  it('titles do not repeat the unit', () => {
    expect(title('cutting_speed_m_min', 'm/min')).toBe('cutting speed');
    expect(title('cutting_speed_m_min')).toBe('cutting speed m min');
    expect(title('mean_temperature_c', 'degC')).toBe('mean temperature');
    expect(title('count', '1')).toBe('count');
  });
  it('an alternative is found by its kind, through a reference', () => {
    const schema: JsonSchema = { oneOf: [{ $ref: '#/definitions/a' }, { properties: { kind: { const: 'b' } } }] };
    const with_: JsonSchema & { definitions: unknown } = { ...schema, definitions: { a: { properties: { kind: { enum: ['a'] }, x: { type: 'number' } } } } };
    expect(Object.keys(alternative(with_, with_, { kind: 'a' })?.properties ?? {})).toEqual(['kind', 'x']);
    expect(alternative(with_, with_, { kind: 'c' })).toBeUndefined();
  });
  it('ranges and bounds', () => {
    expect(rangeOf({ exclusiveMinimum: 0, maximum: 1 })).toBe('> 0, ≤ 1');
    expect(searchBounds({ type: 'number', exclusiveMinimum: 0, exclusiveMaximum: 1 }, 0.64)).toEqual({ low: 0.32, high: 0.9936 });
    expect(searchBounds({ type: 'integer', minimum: 1 }, 1)).toEqual({ low: 1, high: 2 });
    expect(searchBounds({ type: 'number' }, 60)).toEqual({ low: 30, high: 120 });
  });
  it('a property is found wherever it stands', () => {
    expect(findProperty(root, 'edge_life')).toBeDefined();
    expect(findProperty(root, 'no_such_thing')).toBeUndefined();
  });
});
