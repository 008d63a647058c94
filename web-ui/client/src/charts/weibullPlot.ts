// Weibull paper: median ranks of the failures with their 5 and 95 % ranks, and the line through them.

import { significant } from '../format';
import { tooltip } from './chart';
import type { Option } from './echarts';
import type { Theme } from './theme';

export interface WeibullPoint {
  life: number;
  median_rank: number;
  low_5: number;
  high_95: number;
}

const onPaper = (p: number) => Math.log(-Math.log(1 - p));
const percent = (y: number) => `${significant(100 * (1 - Math.exp(-Math.exp(y))), 3)} %`;

export function weibullOption(points: readonly WeibullPoint[], line: { shape: number; scale: number } | undefined, unit: string, words: { life: string; failed: string; line: string; bounds: string }, theme: Theme): Option {
  const xs = points.map((p) => Math.log(p.life));
  const [low, high] = [Math.min(...xs), Math.max(...xs)];
  const dots = (of: (p: WeibullPoint) => number) => points.map((p) => [Math.log(p.life), onPaper(of(p))]);
  return {
    grid: { left: 66, right: 20, top: 36, bottom: 42 },
    legend: { top: 0, left: 0, itemWidth: 14, itemHeight: 8, textStyle: { color: theme.text, fontSize: 12 } },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const { value } = p as { value: [number, number] };
      return `${significant(Math.exp(value[0]), 4)} ${unit}: ${percent(value[1])}`;
    } },
    xAxis: { type: 'value', scale: true, name: `${words.life}, ${unit}`, nameLocation: 'middle', nameGap: 26, nameTextStyle: { color: theme.text, fontSize: 12 }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(Math.exp(v), 3) }, splitLine: { lineStyle: { color: theme.line } } },
    yAxis: { type: 'value', scale: true, name: words.failed, nameLocation: 'middle', nameGap: 50, nameTextStyle: { color: theme.text, fontSize: 12 }, axisLabel: { color: theme.muted, formatter: percent }, splitLine: { lineStyle: { color: theme.line } } },
    series: [
      { type: 'scatter', name: words.failed, symbolSize: 7, itemStyle: { color: theme.accent }, data: dots((p) => p.median_rank) },
      ...[(p: WeibullPoint) => p.low_5, (p: WeibullPoint) => p.high_95].map((of) => ({ type: 'line' as const, name: words.bounds, symbol: 'none', lineStyle: { width: 1, type: 'dashed' as const, color: theme.muted }, itemStyle: { color: theme.muted }, data: dots(of) })),
      ...(line ? [{ type: 'line' as const, name: words.line, symbol: 'none', lineStyle: { width: 2, color: theme.good }, itemStyle: { color: theme.good }, data: [low, high].map((x) => [x, line.shape * (x - Math.log(line.scale))]) }] : []),
    ],
  };
}
