import { describe, expect, it } from 'vitest';
import { difference, studentCdf, studentTwoSided } from '../src/logic/statistics';

describe("Student's t", () => {
  // Critical values of the usual tables (NIST/SEMATECH e-Handbook of Statistical Methods, table 1.3.6.7.2).
  it.each([
    [0.95, 1, 12.706],
    [0.95, 2, 4.303],
    [0.95, 9, 2.262],
    [0.95, 19, 2.093],
    [0.95, 39, 2.023],
    [0.95, 100, 1.984],
    [0.99, 10, 3.169],
    [0.9, 5, 2.015],
  ])('two-sided %f with %i degrees of freedom is %f', (confidence, dof, expected) => {
    expect(studentTwoSided(confidence, dof)).toBeCloseTo(expected, 3);
  });
  it('has its closed forms with one and two degrees of freedom', () => {
    for (const t of [-3, -0.4, 0, 0.7, 5]) {
      expect(studentCdf(t, 1)).toBeCloseTo(0.5 + Math.atan(t) / Math.PI, 12);
      expect(studentCdf(t, 2)).toBeCloseTo(0.5 + t / (2 * Math.sqrt(2 + t * t)), 12);
    }
  });
  it('approaches the normal law', () => {
    expect(studentTwoSided(0.95, 1e6)).toBeCloseTo(1.95996, 4);
  });
});

describe('difference of two runs', () => {
  it('averages paired differences: by hand', () => {
    // differences 1, 2, 3: mean 2, standard deviation 1, t(0.975, 2) = 4.302653
    const d = difference([10, 20, 30], [11, 22, 33], true);
    expect(d?.mean).toBeCloseTo(2, 12);
    expect(d?.halfWidth).toBeCloseTo(4.302653 / Math.sqrt(3), 5);
    expect(d?.verdict).toBe('indistinguishable');
  });
  it('sees through common noise when paired, not when unpaired', () => {
    const noise = [3, -5, 8, -2, 6, -7, 1, 4];
    const a = noise.map((n) => 100 + n);
    const b = noise.map((n, k) => 99 + n + 0.01 * (k % 2));
    expect(difference(a, b, true)?.verdict).toBe('lower');
    expect(difference(a, b, false)?.verdict).toBe('indistinguishable');
  });
  it('agrees with the pooled t interval for equal sizes and variances', () => {
    const d = difference([1, 2, 3, 4], [11, 12, 13, 14], false);
    // both variances 5/3; standard error sqrt(2 * 5/12); 6 degrees of freedom
    expect(d?.halfWidth).toBeCloseTo(2.446912 * Math.sqrt(10 / 12), 5);
    expect(d?.verdict).toBe('higher');
  });
  it('leaves out replications without a value', () => {
    expect(difference([1, null, 3], [2, 5, 4], true)).toMatchObject({ mean: 1, samples: 2, verdict: 'higher' });
    expect(difference([null], [1], true)).toBeNull();
    expect(difference([1], [2], true)?.verdict).toBe('unknown');
  });
});
