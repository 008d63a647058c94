// The history of a search and where in the plane of two variables it looked.

import { significant, unitText } from '../format';
import { t } from '../i18n';
import { bestSoFar, quantile, type Sign } from '../logic/trials';
import type { Trial, Variable } from '../types';
import { tooltip } from './chart';
import type { Option } from './echarts';
import type { Theme } from './theme';

const axis = (theme: Theme, name: string) => ({
  name,
  nameLocation: 'middle' as const,
  nameTextStyle: { color: theme.text, fontSize: 12 },
  axisLabel: { color: theme.muted, formatter: (v: number) => significant(v) },
  splitLine: { lineStyle: { color: theme.line } },
  axisLine: { lineStyle: { color: theme.line } },
});

/**
 * Upper edge of the history: a wide search's far-off trials would press the interesting ones into one line. Nine tenths of
 * the trials, and today's value, lie below it.
 */
export function historyCeiling(trials: readonly Trial[], today: number | null): number {
  const values = trials.flatMap((x) => (x.objective === null ? [] : [x.objective]));
  if (values.length === 0) return NaN;
  const low = quantile(values, 0);
  const high = Math.max(quantile(values, 0.9), today ?? -Infinity);
  return Math.min(quantile(values, 1), high + 0.15 * (high - low));
}

const bestOf = (trials: readonly Trial[], sign: Sign): number => trials.reduce((best, x) => (x.feasible && x.objective !== null && sign * x.objective < sign * best ? x.objective : best), sign * Infinity);

export function historyOption(trials: readonly Trial[], objective: string, unit: string, today: number | null, noise: number | null, theme: Theme, sign: Sign = 1): Option {
  const known = trials.filter((x) => x.objective !== null);
  // Where higher is better the far-off edge is the lower one.
  const turned = sign === 1 ? trials : trials.map((x) => ({ ...x, objective: x.objective === null ? null : -x.objective }));
  const ceiling = sign * historyCeiling(turned, today === null ? null : sign * today);
  const near = (value: number) => sign * value <= sign * ceiling;
  const inside = known.filter((x) => near(x.objective ?? 0));
  const beyond = known.filter((x) => !near(x.objective ?? 0));
  const last = trials.at(-1)?.number ?? 1;
  return {
    grid: { left: 62, right: 18, top: 34, bottom: 42 },
    legend: {
      top: 0, left: 0, itemWidth: 14, itemHeight: 8, textStyle: { color: theme.text, fontSize: 12 },
      data: [
        { name: t('study.trial'), icon: 'circle' },
        { name: t('study.beyond'), icon: 'triangle' },
        { name: t('study.bestSoFar'), icon: 'rect' },
        { name: t('col.today'), icon: 'rect' },
      ],
    },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const [number, value, real] = (p as { value: [number, number, number?] }).value;
      return `${t('study.trial')} ${number}: ${significant(real ?? value)} ${unit}`;
    } },
    xAxis: { type: 'value', min: 1, max: Math.max(2, last), nameGap: 26, ...axis(theme, t('col.number')), splitLine: { show: false } },
    yAxis: { type: 'value', scale: true, nameGap: 46, ...axis(theme, `${objective}, ${unit}`) },
    series: [
      { type: 'scatter', name: t('study.trial'), symbolSize: 4, large: inside.length > 5000, itemStyle: { color: theme.accent, opacity: 0.55 }, data: inside.map((x) => [x.number, x.objective ?? 0]) },
      { type: 'scatter', name: t('study.beyond'), symbol: 'triangle', symbolSize: 7, itemStyle: { color: theme.muted, opacity: 0.7 }, data: beyond.map((x) => [x.number, ceiling, x.objective ?? 0]) },
      { type: 'line', name: t('study.bestSoFar'), step: 'end', symbol: 'none', lineStyle: { color: theme.good, width: 2 }, itemStyle: { color: theme.good }, data: bestSoFar(trials, sign).filter(([, value]) => near(value)) },
      // The band in which a simulation could not tell plans from the best one.
      ...(noise === null || known.length === 0 ? [] : [{ type: 'line' as const, silent: true, symbol: 'none', lineStyle: { opacity: 0 }, data: [], markArea: { silent: true, itemStyle: { color: theme.good, opacity: 0.14 }, data: [[{ yAxis: bestOf(known, sign) - noise }, { yAxis: bestOf(known, sign) + noise }]] as [{ yAxis: number }, { yAxis: number }][] } }]),
      ...(today === null ? [] : [{ type: 'line' as const, name: t('col.today'), symbol: 'none', lineStyle: { color: theme.bad, width: 1.5, type: 'dashed' as const }, itemStyle: { color: theme.bad }, data: [[1, today], [Math.max(2, last), today]] }]),
    ],
  };
}

export interface Mark {
  name: string;
  at: number[];
}

export function planeOption(trials: readonly Trial[], variables: readonly Variable[], x: number, y: number, unit: string, best: Mark | undefined, today: Mark | undefined, theme: Theme): Option {
  const known = trials.filter((r) => r.objective !== null);
  // Dear ones first, so that cheap ones lie on top.
  const points = [...known].sort((a, b) => (b.objective ?? 0) - (a.objective ?? 0));
  const values = known.map((r) => r.objective ?? 0);
  const name = (k: number) => `${variables[k]?.name ?? ''}${unitText(variables[k]?.unit ?? '') ? `, ${unitText(variables[k]?.unit ?? '')}` : ''}`;
  const mark = (m: Mark, symbol: string, size: number, colour: string) => ({
    type: 'scatter' as const,
    name: m.name,
    symbol,
    symbolSize: size,
    z: 5,
    itemStyle: { opacity: 1, color: colour, borderColor: theme.panel, borderWidth: 1.5 },
    label: { show: true, position: 'right' as const, formatter: m.name, color: theme.text, fontWeight: 'bold' as const, backgroundColor: theme.panel, padding: [2, 4], borderRadius: 3 },
    data: [[m.at[x] ?? 0, m.at[y] ?? 0]],
    tooltip: { formatter: () => `${m.name}: ${significant(m.at[x] ?? 0)}; ${significant(m.at[y] ?? 0)}` },
  });
  const low = values.length > 0 ? quantile(values, 0) : 0;
  const high = values.length > 0 ? quantile(values, 0.9) : 1;
  return {
    grid: { left: 58, right: 86, top: 16, bottom: 42 },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const value = (p as { value: number[] }).value;
      return `${t('study.trial')} ${value[3]}\n${significant(value[0] ?? 0)}; ${significant(value[1] ?? 0)}\n${significant(value[2] ?? 0)} ${unit}`;
    } },
    visualMap: {
      type: 'continuous', seriesIndex: 0, dimension: 2, min: low, max: high > low ? high : low + 1, right: 0, top: 'middle', itemHeight: 130, itemWidth: 12,
      calculable: false, text: [`≥ ${significant(high, 4)}`, significant(low, 4)], textStyle: { color: theme.text, fontSize: 11 },
      inRange: { color: [theme.cheap, theme.middle, theme.dear] },
    },
    xAxis: { type: 'value', scale: true, nameGap: 26, ...axis(theme, name(x)) },
    yAxis: { type: 'value', scale: true, nameGap: 40, ...axis(theme, name(y)) },
    series: [
      { type: 'scatter', symbolSize: 6, data: points.map((r) => [r.values[x] ?? 0, r.values[y] ?? 0, r.objective ?? 0, r.number]) },
      ...(today ? [mark(today, 'diamond', 14, theme.bad)] : []),
      ...(best ? [mark(best, 'circle', 13, theme.good)] : []),
    ],
  };
}
