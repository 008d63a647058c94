import { describe, expect, it } from 'vitest';
import { roundKeepingSum } from '../src/logic/shares';

// A small generator of our own: tests must not change from day to day.
function* randoms(seed: number): Generator<number> {
  let s = seed >>> 0;
  for (;;) {
    s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
    yield s / 2 ** 32;
  }
}

describe('shares', () => {
  it('thirds add up to 100.0', () => {
    expect(roundKeepingSum([100 / 3, 100 / 3, 100 / 3], 1)).toEqual([33.4, 33.3, 33.3]);
  });
  it('never gives a share to a state that never was', () => {
    expect(roundKeepingSum([100 / 3, 0, 200 / 3], 1)[1]).toBe(0);
    expect(roundKeepingSum([0, 0], 1)).toEqual([0, 0]);
  });
  it('adds up and stays within one last digit for any shares', () => {
    const r = randoms(7);
    for (let trial = 0; trial < 500; ++trial) {
      const raw = Array.from({ length: 1 + Math.floor((r.next().value as number) * 9) }, () => r.next().value as number);
      const total = raw.reduce((a, b) => a + b, 0);
      const percent = raw.map((x) => (100 * x) / total);
      const rounded = roundKeepingSum(percent, 1, 100);
      expect(rounded.reduce((a, b) => a + Math.round(b * 10), 0)).toBe(1000);
      rounded.forEach((v, k) => expect(Math.abs(v - (percent[k] ?? 0))).toBeLessThanOrEqual(0.1 + 1e-9));
    }
  });
  it('keeps a sum of negative and positive amounts', () => {
    const rounded = roundKeepingSum([10.126, -3.333, 0.004], 2);
    expect(Math.round(100 * rounded.reduce((a, b) => a + b, 0))).toBe(680);
  });
});
