using Avalonia.Media;
using Avalonia.Media.Immutable;

namespace ErrorMatching.Hmi;

/// <summary>Brushes that let through what is behind them. A group with opacity looks the same and takes a bitmap of its size each
/// time.</summary>
internal static class Translucent
{
    /// <summary>A solid color with an opacity; other brushes, which the station does not have, stay as they are.</summary>
    public static IBrush? Of(IBrush? brush, double opacity) =>
        brush is ISolidColorBrush solid ? new ImmutableSolidColorBrush(solid.Color, solid.Opacity * opacity) : brush;
}
