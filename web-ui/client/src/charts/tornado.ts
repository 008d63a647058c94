// What each uncertain input does to the best objective, widest on top.

import { significant } from '../format';
import type { Sensitivity } from '../logic/answer';
import { tooltip } from './chart';
import type { Option } from './echarts';
import type { Theme } from './theme';

export function tornadoOption(rows: readonly Sensitivity[], centre: number, unit: string, names: { low: string; high: string }, theme: Theme): Option {
  const bar = (name: string, colour: string, of: (s: Sensitivity) => number | null) => ({
    type: 'bar' as const, name, barGap: '-100%', barMaxWidth: 22, itemStyle: { color: colour },
    // Bars start at the plan's own objective.
    data: rows.map((s) => { const v = of(s); return v === null ? 0 : v - centre; }),
    tooltip: { valueFormatter: (v: unknown) => `${significant(Number(v) + centre, 6)} ${unit}` },
  });
  return {
    grid: { left: 8, right: 24, top: 34, bottom: 30, containLabel: true },
    legend: { top: 0, left: 0, itemWidth: 12, itemHeight: 12, textStyle: { color: theme.text, fontSize: 12 } },
    tooltip: tooltip(theme),
    xAxis: { type: 'value', name: unit, nameLocation: 'middle', nameGap: 24, nameTextStyle: { color: theme.text }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v + centre, 4) }, splitLine: { lineStyle: { color: theme.line } } },
    yAxis: { type: 'category', inverse: true, data: rows.map((s) => s.name), axisLabel: { color: theme.text, width: 220, overflow: 'truncate' }, axisTick: { show: false }, axisLine: { lineStyle: { color: theme.line } } },
    series: [bar(names.low, '#56B4E9', (s) => s.objective_low), bar(names.high, '#E69F00', (s) => s.objective_high)],
  };
}
