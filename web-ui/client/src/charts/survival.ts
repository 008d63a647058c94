// Survival of edges over their cutting age, with the age at which they are changed.

import { significant } from '../format';
import { t } from '../i18n';
import { tooltip } from './chart';
import type { Option } from './echarts';
import { colourOf, type Theme } from './theme';

export interface SurvivalCurve {
  name: string;
  machine: string;
  /** [age in minutes, share of the edges that reach it] */
  points: [number, number][];
  /** Age and share at which edges are changed; null: at failure only. */
  age: number | null;
  share: number | null;
}

export function survivalOption(curves: readonly SurvivalCurve[], theme: Theme): Option {
  return {
    grid: { left: 58, right: 18, top: 36, bottom: 42 },
    legend: { top: 0, left: 0, itemWidth: 14, itemHeight: 8, textStyle: { color: theme.text, fontSize: 12 } },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const { seriesName, value } = p as { seriesName: string; value: [number, number] };
      return `${seriesName}\n${significant(value[0], 4)} min: ${significant(100 * value[1], 3)} %`;
    } },
    xAxis: { type: 'value', min: 0, name: `${t('sheet.age')}, min`, nameLocation: 'middle', nameGap: 26, nameTextStyle: { color: theme.text, fontSize: 12 }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v, 4) }, splitLine: { show: false } },
    yAxis: { type: 'value', min: 0, max: 1, axisLabel: { color: theme.muted, formatter: (v: number) => `${Math.round(100 * v)} %` }, splitLine: { lineStyle: { color: theme.line } } },
    series: curves.flatMap((c, k) => [
      { type: 'line' as const, name: c.name, symbol: 'none', lineStyle: { width: 2, color: colourOf(c.name, k) }, itemStyle: { color: colourOf(c.name, k) }, data: [[0, 1], ...c.points] },
      ...(c.age === null || c.share === null ? [] : [{ type: 'scatter' as const, name: c.name, symbol: 'diamond', symbolSize: 13, itemStyle: { color: colourOf(c.name, k), borderColor: theme.panel, borderWidth: 1 }, label: { show: true, position: 'right' as const, color: theme.text, formatter: t('sheet.changed') }, data: [[c.age, c.share]] }]),
    ]),
  };
}
