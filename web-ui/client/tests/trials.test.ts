import { describe, expect, it } from 'vitest';
import { bestSoFar, distinctPlans, quantile, ranked } from '../src/logic/trials';
import { historyCeiling, historyOption } from '../src/charts/trials';
import { matchRoute } from '../src/routes';
import type { Trial } from '../src/types';

const trial = (number: number, objective: number | null, feasible = true): Trial => ({ number, stage: 'analytic', values: [number], objective, feasible });
const trials = [trial(1, 5), trial(2, 7), trial(3, 1, false), trial(4, 3), trial(5, null), trial(6, 4)];
const theme = { font: '', text: '', muted: '', line: '', panel: '', accent: '', good: '', bad: '', cheap: '', middle: '', dear: '' };

describe('trials of a study', () => {
  it('the best so far falls, ignores infeasible trials and reaches the last one', () => {
    expect(bestSoFar(trials)).toEqual([[1, 5], [4, 3], [6, 3]]);
    expect(bestSoFar([])).toEqual([]);
    expect(bestSoFar(trials, -1)).toEqual([[1, 5], [2, 7], [6, 7]]);
    expect(ranked(trials, -1).map((t) => t.number)).toEqual([2, 1, 6, 4]);
  });
  it('are ranked cheapest first', () => {
    expect(ranked(trials).map((t) => t.number)).toEqual([4, 6, 1, 2]);
  });
  it('plans that agree to three digits are listed once, by their cheapest trial', () => {
    const near = (number: number, value: number, objective: number): Trial => ({ ...trial(number, objective), values: [value, 46.97] });
    expect(distinctPlans([near(1, 0.4704, 5), near(2, 0.4703, 4), near(3, 0.48, 6)]).map((t) => t.number)).toEqual([2, 3]);
  });
  it('quantiles are members of the list', () => {
    expect(quantile([4, 1, 3, 2], 0.5)).toBe(2);
    expect(quantile([4, 1, 3, 2], 1)).toBe(4);
  });
  it('the history chart draws every trial that has a value, far-off ones at its edge', () => {
    const many = [...Array.from({ length: 20 }, (_, k) => trial(k + 1, 100 + k)), trial(21, 5000), trial(22, null)];
    const ceiling = historyCeiling(many, 110);
    expect(ceiling).toBeGreaterThan(118);
    expect(ceiling).toBeLessThan(130);
    const [inside, beyond, best, today] = historyOption(many, 'cost', 'UAH', 110, null, theme).series as { data: number[][] }[];
    expect(inside?.data).toHaveLength(20);
    expect(inside?.data[3]).toEqual([4, 103]);
    expect(beyond?.data).toEqual([[21, ceiling, 5000]]);
    expect(best?.data).toEqual([[1, 100], [22, 100]]);
    expect(today?.data).toEqual([[1, 110], [22, 110]]);
  });
});

describe('addresses', () => {
  it.each([
    ['', 'home', []],
    ['#/', 'home', []],
    ['#/runs/12', 'run', ['12']],
    ['#/compare/2/3', 'compare', ['2/3']],
    ['#/compare/2/3/9', 'compare', ['2/3/9']],
    ['#/scenario/run/3', 'scenario', ['run', '3']],
    ['#/operations', 'operations', []],
    ['#/operations/deep_hole_drilling', 'operations', ['deep_hole_drilling']],
    ['#/models/K117.part_cost', 'model', ['K117.part_cost']],
  ])('%s', (hash, page, parameters) => expect(matchRoute(hash)).toEqual({ page, parameters }));
  it.each(['#/runs/abc', '#/runs/1/2', '#/models/../x', '#/nothing'])('%s is no page', (hash) => expect(matchRoute(hash)).toBeNull());
});
