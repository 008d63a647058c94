// Further views of a search: parallel coordinates, one variable at a time, several objectives against each other.

import { significant, unitText } from '../format';
import { t } from '../i18n';
import { distinctPlans, quantile, type Sign } from '../logic/trials';
import type { Trial, Variable } from '../types';
import { tooltip } from './chart';
import type { AnyOption, Option } from './echarts';
import type { Theme } from './theme';

/** Every plan a line through its variables and its objective; the best in colour. */
export function parallelOption(trials: readonly Trial[], variables: readonly Variable[], objective: string, theme: Theme, sign: Sign = 1): AnyOption {
  const best = distinctPlans(trials, sign).slice(0, 400);
  const values = best.map((x) => x.objective ?? 0);
  const low = values.length > 0 ? quantile(values, 0) : 0;
  const high = values.length > 0 ? quantile(values, 1) : 1;
  const axis = { nameTextStyle: { color: theme.text, fontSize: 11 }, axisLine: { lineStyle: { color: theme.muted } }, axisTick: { lineStyle: { color: theme.muted } }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v, 4) } };
  return {
    parallel: { left: 84, right: 84, top: 40, bottom: 22 },
    parallelAxis: [...variables.map((v, k) => ({ dim: k, name: v.name.length > 22 ? `${v.name.slice(0, 21)}…` : v.name, scale: true, ...axis })), { dim: variables.length, name: objective, scale: true, ...axis }],
    visualMap: { show: false, type: 'continuous', dimension: variables.length, min: low, max: high > low ? high : low + 1, inRange: { color: sign === 1 ? [theme.cheap, theme.middle, theme.dear] : [theme.dear, theme.middle, theme.cheap] } },
    series: [{ type: 'parallel', lineStyle: { width: 1, opacity: 0.45 }, data: [...best].reverse().map((x) => [...x.values, x.objective ?? 0]) }],
  };
}

/** Objective against one variable. */
export function sliceOption(trials: readonly Trial[], variable: Variable, place: number, objective: string, unit: string, today: number | undefined, theme: Theme, sign: Sign = 1): Option {
  const known = trials.filter((x) => x.objective !== null);
  const values = known.map((x) => x.objective ?? 0);
  const edge = values.length > 0 ? quantile(values, sign === 1 ? 0.9 : 0.1) : 1;
  const shown = known.filter((x) => sign * (x.objective ?? 0) <= sign * edge);
  const name = `${variable.name}${unitText(variable.unit) ? `, ${unitText(variable.unit)}` : ''}`;
  return {
    grid: { left: 62, right: 18, top: 16, bottom: 42 },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const [x, y] = (p as { value: [number, number] }).value;
      return `${significant(x)}: ${significant(y)} ${unit}`;
    } },
    xAxis: { type: 'value', scale: true, name, nameLocation: 'middle', nameGap: 26, nameTextStyle: { color: theme.text, fontSize: 12 }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v, 4) }, splitLine: { lineStyle: { color: theme.line } } },
    yAxis: { type: 'value', scale: true, name: `${objective}, ${unit}`, nameLocation: 'middle', nameGap: 46, nameTextStyle: { color: theme.text, fontSize: 12 }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v) }, splitLine: { lineStyle: { color: theme.line } } },
    series: [
      { type: 'scatter', symbolSize: 5, itemStyle: { color: theme.accent, opacity: 0.55 }, data: shown.map((x) => [x.values[place] ?? 0, x.objective ?? 0]),
        ...(today === undefined ? {} : { markLine: { symbol: 'none', silent: true, lineStyle: { color: theme.bad, type: 'dashed' as const }, label: { formatter: t('col.today'), color: theme.text }, data: [{ xAxis: today }] } }) },
    ],
  };
}

export interface FrontPoint {
  objectives: number[];
  knee: boolean;
}

/** Two objectives of a front against each other. */
export function frontOption(points: readonly FrontPoint[], names: readonly string[], theme: Theme): Option {
  const axis = (name: string) => ({ type: 'value' as const, scale: true, name, nameLocation: 'middle' as const, nameTextStyle: { color: theme.text, fontSize: 12 }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v) }, splitLine: { lineStyle: { color: theme.line } } });
  const at = (p: FrontPoint) => [p.objectives[0] ?? 0, p.objectives[1] ?? 0];
  return {
    grid: { left: 66, right: 24, top: 20, bottom: 42 },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => (p as { value: number[] }).value.map((v, k) => `${names[k] ?? ''}: ${significant(v)}`).join('\n') },
    xAxis: { ...axis(names[0] ?? ''), nameGap: 26 },
    yAxis: { ...axis(names[1] ?? ''), nameGap: 48 },
    series: [
      { type: 'scatter', name: t('study.front'), symbolSize: 9, itemStyle: { color: theme.accent }, data: points.map(at) },
      { type: 'scatter', name: t('study.knee'), symbol: 'diamond', symbolSize: 16, itemStyle: { color: theme.good }, label: { show: true, position: 'right', formatter: t('study.knee'), color: theme.text }, data: points.filter((p) => p.knee).map(at) },
    ],
  };
}
