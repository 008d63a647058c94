// Between the texts of a form and the inputs of a model function.

import type { Field } from '../types';

export class FieldError extends Error {
  constructor(
    readonly field: string,
    readonly reason: 'number' | 'integer' | 'json' | 'required' | 'ambiguous',
  ) {
    super(`${field}: ${reason}`);
  }
}

/**
 * A number as people type it: decimal point or comma, spaces as thousands separators. Null when it is none; throws
 * nothing. "1,234.5" is refused rather than guessed.
 */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace(/[\s\u00a0\u202f]/g, '').replace('\u2212', '-');
  if (!/^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const value = Number(plain.replace(',', '.'));
  return Number.isFinite(value) ? value : null;
}

/** The input a text stands for; undefined when it is empty and may be left out. Throws FieldError. */
export function readField(field: Field, text: string): unknown {
  const given = text.trim();
  if (given === '') {
    if (field.required) throw new FieldError(field.name, 'required');
    return undefined;
  }
  switch (field.kind) {
    case 'number': {
      const value = parseNumber(given);
      if (value === null) throw new FieldError(field.name, 'number');
      return value;
    }
    case 'integer': {
      const value = parseNumber(given);
      if (value === null || !Number.isSafeInteger(value)) throw new FieldError(field.name, 'integer');
      return value;
    }
    case 'flag':
      return given === 'true';
    case 'text':
    case 'choice':
      return given;
    default:
      try {
        return JSON.parse(given) as unknown;
      } catch {
        throw new FieldError(field.name, 'json');
      }
  }
}

/** How a value stands in a form. */
export function writeField(field: Field, value: unknown): string {
  if (value === undefined || value === null) return '';
  if (field.kind === 'list' || field.kind === 'structure' || field.kind === 'alternatives') return JSON.stringify(value);
  return String(value);
}

/** The allowed range, "0 < x ≤ 1", or an empty text. */
export function rangeText(field: Field): string {
  const low = field.above !== undefined ? `${field.above} <` : field.at_least !== undefined ? `${field.at_least} ≤` : '';
  const high = field.below !== undefined ? `< ${field.below}` : field.at_most !== undefined ? `≤ ${field.at_most}` : '';
  if (!low && !high) return '';
  if (low && high) return `${low} ${field.name} ${high}`;
  if (low) return field.above !== undefined ? `> ${field.above}` : `≥ ${String(field.at_least)}`;
  return high;
}

const provenances = ['paper', 'repaired', 'reconstructed', 'completion'] as const;

/** The deciding word of a provenance: "paper, repaired" is repaired, "COMPLETION" a completion. */
export function provenanceKind(provenance: string): (typeof provenances)[number] | undefined {
  const last = provenance.toLowerCase().split(/[\s,]+/).at(-1);
  return provenances.find((p) => p === last);
}

/** Ends of a slider for a number: its range where that is closed and not vast, else from half to double its value. */
export function sliderRange(field: Field, value: number): { low: number; high: number } {
  const size = Math.abs(value);
  const nudge = (size > 0 ? size : 1) * 1e-3;
  const floor = field.at_least ?? (field.above !== undefined ? field.above + nudge : -Infinity);
  const ceiling = field.at_most ?? (field.below !== undefined ? field.below - nudge : Infinity);
  const narrow = Number.isFinite(floor) && Number.isFinite(ceiling) && ceiling - floor <= 4 * Math.max(size, 1e-9);
  const digits = (x: number) => Number(x.toPrecision(6));
  if (narrow) return { low: digits(floor), high: digits(ceiling) };
  if (field.kind === 'integer') return { low: Math.max(floor, Math.floor(value / 2)), high: Math.min(ceiling, Math.max(Math.ceil(2 * value), value + 1)) };
  const low = value === 0 ? -1 : value - size / 2;
  const high = value === 0 ? 1 : value + size;
  return { low: digits(Math.max(low, floor)), high: digits(Math.min(high, ceiling)) };
}

/** `count` values from `low` to `high`, both included; whole numbers each once. */
export function spread(low: number, high: number, count: number, integer: boolean): number[] {
  const all = Array.from({ length: count }, (_, k) => low + ((high - low) * k) / (count - 1));
  return integer ? [...new Set(all.map(Math.round))] : all;
}
