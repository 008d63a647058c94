// A function of the catalogue along one input, or over two as a map of colours; gaps where it is not defined.

import { significant } from '../format';
import { t } from '../i18n';
import { stretches } from './sweep';
import { tooltip } from './chart';
import type { Option } from './echarts';
import type { Theme } from './theme';

const numberAxis = (theme: Theme, name: string, gap: number) => ({
  type: 'value' as const, scale: true, name, nameLocation: 'middle' as const, nameGap: gap, nameTextStyle: { color: theme.text, fontSize: 12 },
  axisLabel: { color: theme.muted, formatter: (v: number) => significant(v, 4) }, splitLine: { lineStyle: { color: theme.line } },
});

export function curveOption(xs: readonly number[], values: readonly (number | null)[], x: string, y: string, now: number, theme: Theme): Option {
  const gaps = stretches(xs.map((value, k) => ({ value, bad: values[k] === null || values[k] === undefined })));
  return {
    grid: { left: 66, right: 18, top: 16, bottom: 44 },
    tooltip: { ...tooltip(theme), trigger: 'axis', valueFormatter: (v: unknown) => (typeof v === 'number' ? significant(v) : t('map.undefined')) },
    xAxis: { ...numberAxis(theme, x, 26), min: xs[0] ?? 0, max: xs.at(-1) ?? 1 },
    yAxis: numberAxis(theme, y, 50),
    series: [{
      type: 'line', name: y, symbol: 'none', lineStyle: { color: theme.accent, width: 2 }, itemStyle: { color: theme.accent }, connectNulls: false, data: xs.map((v, k) => [v, values[k] ?? null]),
      markLine: { symbol: 'none', silent: true, label: { formatter: t('plan.now'), color: theme.text }, lineStyle: { color: theme.muted, type: 'dashed' }, data: [{ xAxis: now }] },
      markArea: { silent: true, itemStyle: { color: theme.muted, opacity: 0.18 }, data: gaps.map(([from, to]) => [{ xAxis: from }, { xAxis: to }] as [{ xAxis: number }, { xAxis: number }]) },
    }],
  };
}

export function mapOption(xs: readonly number[], ys: readonly number[], values: readonly (readonly (number | null)[])[], x: string, y: string, z: string, theme: Theme): Option {
  const known = values.flat().filter((v): v is number => v !== null);
  const low = known.reduce((a, b) => Math.min(a, b), Infinity);
  const high = known.reduce((a, b) => Math.max(a, b), -Infinity);
  const axis = (name: string, data: readonly number[], gap: number) => ({ type: 'category' as const, name, nameLocation: 'middle' as const, nameGap: gap, nameTextStyle: { color: theme.text, fontSize: 12 }, data: data.map((v) => significant(v, 4)), axisLabel: { color: theme.muted }, axisTick: { show: false }, splitArea: { show: false } });
  return {
    grid: { left: 72, right: 96, top: 16, bottom: 46 },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const [i, j, v] = (p as { value: [number, number, number | null] }).value;
      return `${x}: ${significant(xs[i] ?? 0)}\n${y}: ${significant(ys[j] ?? 0)}\n${z}: ${typeof v === 'number' ? significant(v) : t('map.undefined')}`;
    } },
    visualMap: { type: 'continuous', min: Number.isFinite(low) ? low : 0, max: high > low ? high : low + 1, calculable: false, right: 0, top: 'middle', itemHeight: 160, itemWidth: 12, text: [significant(Number.isFinite(high) ? high : 1, 4), significant(Number.isFinite(low) ? low : 0, 4)], textStyle: { color: theme.text, fontSize: 11 }, inRange: { color: ['#0d0887', '#7e03a8', '#cc4778', '#f89540', '#f0f921'] } },
    xAxis: axis(x, xs, 28),
    yAxis: axis(y, ys, 54),
    series: [{ type: 'heatmap', data: ys.flatMap((_, j) => xs.map((__, i) => [i, j, values[j]?.[i] ?? '-'])), progressive: 0 }],
  };
}
