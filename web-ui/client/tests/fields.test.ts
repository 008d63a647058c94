import { describe, expect, it } from 'vitest';
import { FieldError, parseNumber, provenanceKind, rangeText, readField } from '../src/logic/fields';
import type { Field } from '../src/types';

const field = (kind: Field['kind'], required = true): Field => ({ name: 'x', symbol: 'x', unit: '1', type: kind, kind, meaning: '', required });

describe('numbers as people type them', () => {
  it.each([
    ['0.5', 0.5],
    ['0,5', 0.5],
    [' 12 000,5 ', 12000.5],
    ['-3', -3],
    ['\u22123', -3],
    ['1e-3', 0.001],
    ['.5', 0.5],
  ])('%s', (text, value) => expect(parseNumber(text)).toBe(value));
  it.each(['', 'abc', '1,234.5', '1.2.3', '0x10', 'Infinity', 'NaN', '1e999', '--1', '5 mm'])('refuses %s', (text) => expect(parseNumber(text)).toBeNull());
});

describe('provenance', () => {
  it.each([
    ['paper', 'paper'],
    ['paper, repaired', 'repaired'],
    ['paper, reconstructed', 'reconstructed'],
    ['COMPLETION', 'completion'],
    ['hearsay', undefined],
  ])('%s', (text, kind) => expect(provenanceKind(text)).toBe(kind));
});

describe('fields of a form', () => {
  it('leave out what is empty and optional, and name what is missing', () => {
    expect(readField(field('number', false), ' ')).toBeUndefined();
    expect(() => readField(field('number'), '')).toThrow(FieldError);
  });
  it('read each kind', () => {
    expect(readField(field('integer'), '4')).toBe(4);
    expect(() => readField(field('integer'), '4.5')).toThrow('integer');
    expect(readField(field('flag'), 'false')).toBe(false);
    expect(readField(field('choice'), 'age')).toBe('age');
    expect(readField(field('list'), '[1, 2]')).toEqual([1, 2]);
    expect(() => readField(field('list'), '[1, 2')).toThrow('json');
  });
  it('say the allowed range', () => {
    expect(rangeText({ ...field('number'), above: 0, at_most: 1 })).toBe('0 < x ≤ 1');
    expect(rangeText({ ...field('number'), at_least: 0 })).toBe('≥ 0');
    expect(rangeText(field('number'))).toBe('');
  });
});
