// Queue lengths over time, a step line per machine group.

import { significant } from '../format';
import { t } from '../i18n';

import { tooltip } from './chart';
import type { Option } from './echarts';
import { colourOf, type Theme } from './theme';

export function queueOption(queues: readonly { name: string; points: [number, number][] }[], end: number, theme: Theme, counted: string = t('trace.waiting')): Option {
  return {
    grid: { left: 52, right: 18, top: 40, bottom: 42 },
    legend: { top: 0, left: 0, itemWidth: 14, itemHeight: 8, textStyle: { color: theme.text, fontSize: 12 } },
    tooltip: tooltip(theme),
    xAxis: { type: 'value', min: 0, max: end, name: 'min', nameLocation: 'middle', nameGap: 26, nameTextStyle: { color: theme.text }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v) }, splitLine: { show: false } },
    yAxis: { type: 'value', minInterval: 1, name: counted, nameTextStyle: { color: theme.text }, axisLabel: { color: theme.muted }, splitLine: { lineStyle: { color: theme.line } } },
    series: queues.map((q, k) => ({
      type: 'line', name: q.name, step: 'end', symbol: 'none', sampling: 'max', lineStyle: { width: 1.5, color: colourOf(q.name, k) }, itemStyle: { color: colourOf(q.name, k) },
      data: [...q.points, [end, q.points.at(-1)?.[1] ?? 0]],
    })),
  };
}
