// Where each machine's time went: one bar of 100 % per machine.

import { fixed } from '../format';
import { tooltip } from './chart';
import type { Option } from './echarts';
import { colourOf, textOn, type Theme } from './theme';

export interface TimeRow {
  machine: string;
  /** Percent per state, in the order of `states`; they add up to 100.0. */
  percent: number[];
}

/** `names` as printed; `keys` decide the colours. */
export function timeBars(names: readonly string[], rows: readonly TimeRow[], theme: Theme, keys: readonly string[] = names): Option {
  return {
    // The legend takes another line for every four names.
    grid: { left: 8, right: 16, top: 14 + 20 * Math.max(1, Math.ceil(names.length / 4)), bottom: 4, containLabel: true },
    legend: { top: 0, left: 0, itemWidth: 12, itemHeight: 12, textStyle: { color: theme.text, fontSize: 12 } },
    tooltip: tooltip(theme),
    xAxis: { type: 'value', min: 0, max: 100, axisLabel: { color: theme.muted, formatter: (v: number) => `${v} %` }, splitLine: { lineStyle: { color: theme.line } } },
    yAxis: { type: 'category', inverse: true, data: rows.map((r) => r.machine), axisLabel: { color: theme.text, width: 160, overflow: 'truncate' }, axisTick: { show: false }, axisLine: { lineStyle: { color: theme.line } } },
    series: names.map((name, k) => ({
      type: 'bar' as const,
      name,
      stack: 'time',
      barMaxWidth: 30,
      itemStyle: { color: colourOf(keys[k] ?? name, k) },
      data: rows.map((r) => r.percent[k] ?? 0),
      label: { show: true, color: textOn(colourOf(keys[k] ?? name, k)), fontSize: 11, formatter: (p: { value?: unknown }) => (Number(p.value) >= 4 ? fixed(Number(p.value), 1) : '') },
      tooltip: { valueFormatter: (v: unknown) => `${fixed(Number(v), 1)} %` },
    })),
  };
}
