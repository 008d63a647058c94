// Student's t and paired differences, for the comparison of two runs.

/** ln Gamma(x), x > 0, by Stirling's series after shifting x above 8; relative error below 1e-14. */
function logGamma(x: number): number {
  let shift = 0;
  let z = x;
  while (z < 8) {
    shift += Math.log(z);
    z += 1;
  }
  const r = 1 / (z * z);
  const series = (1 / 12 - r * (1 / 360 - r * (1 / 1260 - r * (1 / 1680 - (r * 1) / 1188)))) / z;
  return (z - 0.5) * Math.log(z) - z + 0.5 * Math.log(2 * Math.PI) + series - shift;
}

/** Regularized incomplete beta function I_x(a, b) by its continued fraction (modified Lentz), 0 <= x <= 1. */
function incompleteBeta(x: number, a: number, b: number): number {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  if (x > (a + 1) / (a + b + 2)) return 1 - incompleteBeta(1 - x, b, a);
  const front = Math.exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * Math.log(x) + b * Math.log1p(-x)) / a;
  const tiny = 1e-300;
  let c = 1;
  let d = 1 - ((a + b) * x) / (a + 1);
  d = 1 / (Math.abs(d) < tiny ? tiny : d);
  let f = d;
  for (let m = 1; m < 500; ++m) {
    for (const term of [
      (m * (b - m) * x) / ((a + 2 * m - 1) * (a + 2 * m)),
      (-(a + m) * (a + b + m) * x) / ((a + 2 * m) * (a + 2 * m + 1)),
    ]) {
      d = 1 + term * d;
      d = 1 / (Math.abs(d) < tiny ? tiny : d);
      c = 1 + term / c;
      c = Math.abs(c) < tiny ? tiny : c;
      f *= c * d;
    }
    if (Math.abs(c * d - 1) < 1e-15) break;
  }
  return front * f;
}

/** P(T <= t) of Student's t with `dof` > 0 degrees of freedom. */
export function studentCdf(t: number, dof: number): number {
  const tail = 0.5 * incompleteBeta(dof / (dof + t * t), dof / 2, 0.5);
  return t > 0 ? 1 - tail : tail;
}

/** The t with P(|T| <= t) = confidence; 0 < confidence < 1, dof >= 1. Bisection: 60 halvings of [0, 1e4]. */
export function studentTwoSided(confidence: number, dof: number): number {
  const p = 0.5 + confidence / 2;
  let low = 0;
  let high = 1e4;
  for (let k = 0; k < 60; ++k) {
    const mid = (low + high) / 2;
    if (studentCdf(mid, dof) < p) low = mid;
    else high = mid;
  }
  return (low + high) / 2;
}

export interface Difference {
  /** b minus a */
  mean: number;
  halfWidth: number | null;
  /** Replications that both have, or both samples' sizes when not paired. */
  samples: number;
  paired: boolean;
  verdict: 'higher' | 'lower' | 'indistinguishable' | 'unknown';
}

function moments(values: readonly number[]): { mean: number; variance: number } {
  const n = values.length;
  const mean = values.reduce((a, b) => a + b, 0) / n;
  return { mean, variance: n > 1 ? values.reduce((s, v) => s + (v - mean) ** 2, 0) / (n - 1) : 0 };
}

function verdict(mean: number, halfWidth: number | null): Difference['verdict'] {
  if (halfWidth === null) return 'unknown';
  if (Math.abs(mean) <= halfWidth) return 'indistinguishable';
  return mean > 0 ? 'higher' : 'lower';
}

/**
 * Difference b - a with its half-width at 95 %. `paired`: replication r of both saw the same random numbers (same seed),
 * so that the differences per replication are averaged; else Welch's interval. Null when there is nothing to compare.
 */
export function difference(a: readonly (number | null)[], b: readonly (number | null)[], paired: boolean): Difference | null {
  if (paired) {
    const d: number[] = [];
    for (let r = 0; r < Math.min(a.length, b.length); ++r) {
      const [x, y] = [a[r], b[r]];
      if (typeof x === 'number' && typeof y === 'number') d.push(y - x);
    }
    if (d.length === 0) return null;
    const { mean, variance } = moments(d);
    const halfWidth = d.length < 2 ? null : studentTwoSided(0.95, d.length - 1) * Math.sqrt(variance / d.length);
    return { mean, halfWidth, samples: d.length, paired, verdict: verdict(mean, halfWidth) };
  }
  const x = a.filter((v): v is number => typeof v === 'number');
  const y = b.filter((v): v is number => typeof v === 'number');
  if (x.length === 0 || y.length === 0) return null;
  const [ma, mb] = [moments(x), moments(y)];
  const mean = mb.mean - ma.mean;
  if (x.length < 2 || y.length < 2) return { mean, halfWidth: null, samples: x.length + y.length, paired, verdict: 'unknown' };
  const [va, vb] = [ma.variance / x.length, mb.variance / y.length];
  let halfWidth = 0;
  if (va + vb > 0) {
    const dof = (va + vb) ** 2 / (va ** 2 / (x.length - 1) + vb ** 2 / (y.length - 1));
    halfWidth = studentTwoSided(0.95, dof) * Math.sqrt(va + vb);
  }
  return { mean, halfWidth, samples: x.length + y.length, paired, verdict: verdict(mean, halfWidth) };
}
