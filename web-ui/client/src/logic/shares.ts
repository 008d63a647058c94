// Rounding that keeps sums: printed shares add up to 100.0 %, printed cost components to the printed total.

/**
 * Rounds `values` to `digits` decimals so that they add up to `total` rounded likewise (largest remainder).
 * Every rounded value is within one unit of the last digit of its own value. Works on integers, so the sum is
 * exact in units of the last digit.
 * @param values finite numbers
 * @param total what they must add up to; default their own sum
 */
export function roundKeepingSum(values: readonly number[], digits: number, total?: number): number[] {
  const unit = 10 ** digits;
  const target = Math.round((total ?? values.reduce((a, b) => a + b, 0)) * unit);
  const floors = values.map((v) => Math.floor(v * unit));
  let missing = target - floors.reduce((a, b) => a + b, 0);
  // Exact zeros stay zeros: an absent state must not show 0.1 %.
  const order = values
    .map((v, k) => ({ k, rest: v * unit - (floors[k] ?? 0), zero: v === 0 }))
    .filter((e) => !e.zero)
    .sort((a, b) => b.rest - a.rest || a.k - b.k);
  const rounded = [...floors];
  for (let i = 0; missing > 0 && order.length > 0; i = (i + 1) % order.length, --missing) {
    const k = order[i]?.k ?? 0;
    rounded[k] = (rounded[k] ?? 0) + 1;
  }
  for (let i = order.length - 1; missing < 0 && order.length > 0; i = (i + order.length - 1) % order.length, ++missing) {
    const k = order[i]?.k ?? 0;
    rounded[k] = (rounded[k] ?? 0) - 1;
  }
  return rounded.map((r) => r / unit);
}
