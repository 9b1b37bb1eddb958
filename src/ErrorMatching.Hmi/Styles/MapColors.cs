using Avalonia.Media;
using Avalonia.Media.Immutable;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>The colors of map values, as in the reports, in every theme.</summary>
internal static class MapColors
{
    /// <summary>From the lowest value to the highest.</summary>
    public static IReadOnlyList<IBrush> Scale { get; } = [
        .. Enumerable.Range(0, DivergingColors.Count).Select(i => new ImmutableSolidColorBrush(Color.Parse(DivergingColors.Hex(i))))];
}
