import { describe, expect, it } from 'vitest';
import { bestSoFar, quantile, ranked } from '../src/logic/trials';
import { historyOption } from '../src/charts/trials';
import { matchRoute } from '../src/routes';
import type { Trial } from '../src/types';

const trial = (number: number, objective: number | null, feasible = true): Trial => ({ number, stage: 'analytic', values: [number], objective, feasible });
const trials = [trial(1, 5), trial(2, 7), trial(3, 1, false), trial(4, 3), trial(5, null), trial(6, 4)];
const theme = { text: '', muted: '', line: '', panel: '', accent: '', good: '', bad: '', cheap: '', middle: '', dear: '' };

describe('trials of a study', () => {
  it('the best so far falls, ignores infeasible trials and reaches the last one', () => {
    expect(bestSoFar(trials)).toEqual([[1, 5], [4, 3], [6, 3]]);
    expect(bestSoFar([])).toEqual([]);
  });
  it('are ranked cheapest first', () => {
    expect(ranked(trials).map((t) => t.number)).toEqual([4, 6, 1, 2]);
  });
  it('quantiles are members of the list', () => {
    expect(quantile([4, 1, 3, 2], 0.5)).toBe(2);
    expect(quantile([4, 1, 3, 2], 1)).toBe(4);
  });
  it('the history chart draws every trial that has a value', () => {
    const option = historyOption(trials, 'cost', 'UAH', theme);
    const series = option.series as { data: number[][] }[];
    expect(series[0]?.data).toEqual([[1, 5], [2, 7], [3, 1], [4, 3], [6, 4]]);
  });
});

describe('addresses', () => {
  it.each([
    ['', 'home', []],
    ['#/', 'home', []],
    ['#/runs/12', 'run', ['12']],
    ['#/compare/2/3', 'compare', ['2', '3']],
    ['#/models/K117.part_cost', 'model', ['K117.part_cost']],
  ])('%s', (hash, page, parameters) => expect(matchRoute(hash)).toEqual({ page, parameters }));
  it.each(['#/runs/abc', '#/runs/1/2', '#/models/../x', '#/nothing'])('%s is no page', (hash) => expect(matchRoute(hash)).toBeNull());
});
