// The cost of a part as a bridge: floating bars that end on the total.

import { fixed, significant } from '../format';
import { named } from '../i18n';
import type { BridgeBar } from '../logic/bridge';
import { tooltip } from './chart';
import type { Option } from './echarts';
import { colourOf, type Theme } from './theme';

export function barName(bar: BridgeBar): string {
  return bar.total || bar.key === 'unassigned' || bar.key === 'scrapped_parts' ? named('bridge', bar.key) : named('cost', bar.key);
}

export function bridgeOption(bars: readonly BridgeBar[], currency: string, theme: Theme): Option {
  return {
    grid: { left: 8, right: 12, top: 22, bottom: 4, containLabel: true },
    tooltip: { ...tooltip(theme), formatter: (p: unknown) => {
      const bar = bars[(p as { dataIndex: number }).dataIndex];
      return bar ? `${barName(bar)}: ${fixed(bar.printed, 2)} ${currency}` : '';
    } },
    xAxis: { type: 'category', data: bars.map(barName), axisLabel: { color: theme.text, interval: 0, width: 84, overflow: 'break', fontSize: 11, lineHeight: 13 }, axisTick: { show: false }, axisLine: { lineStyle: { color: theme.line } } },
    yAxis: { type: 'value', name: currency, nameTextStyle: { color: theme.muted, align: 'right' }, axisLabel: { color: theme.muted, formatter: (v: number) => significant(v) }, splitLine: { lineStyle: { color: theme.line } } },
    series: [
      // The invisible pillar on which a floating bar stands.
      { type: 'bar', stack: 'bridge', silent: true, itemStyle: { color: 'transparent' }, data: bars.map((b) => Math.min(b.from, b.to)), barMaxWidth: 52 },
      {
        type: 'bar',
        stack: 'bridge',
        barMaxWidth: 52,
        data: bars.map((b, k) => ({ value: Math.abs(b.to - b.from), itemStyle: { color: b.total ? theme.muted : colourOf(b.key, k) } })),
        label: { show: true, position: 'top', color: theme.text, fontSize: 11, formatter: (p: { dataIndex: number }) => fixed(bars[p.dataIndex]?.printed ?? 0, 2) },
      },
    ],
  };
}
