using System.Globalization;
using System.Text.RegularExpressions;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The screen and tab that show a field of the draft.</summary>
/// <param name="ScreenKey">Key of the screen.</param>
/// <param name="Side">Number of the tab in the system setup; 0 for the point setup.</param>
internal sealed partial record ProblemPlace(string ScreenKey, int Side)
{
    public const int Coordinates = 0;

    /// <summary>The tab with program and blocks.</summary>
    public const int Blocks = 1;

    public const int Tolerances = 2;

    /// <summary>The tab with frame, tool and alignment.</summary>
    public const int Machine = 3;

    /// <summary>The tab with the gauge and everything without another place.</summary>
    public const int Gauge = 4;

    public static ProblemPlace Of(MatingDraft draft, string path) =>
        IsOfPoints(draft, path) ? new(ScreenKeys.Points, 0) : new(ScreenKeys.System, path switch
        {
            _ when path.Contains('/', StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.Part, StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.OtherPoints, StringComparison.Ordinal) =>
                Coordinates,
            _ when path.EndsWith(']')
                && path.Contains($".{FeatureDraft.PointsKey}[", StringComparison.Ordinal)
                && path.StartsWith(DraftPaths.Features, StringComparison.Ordinal) =>
                Coordinates,
            _ when path.Contains("." + FeatureDraft.BlocksKey, StringComparison.Ordinal)
                || path is DraftPaths.Program or DraftPaths.Dialect => Blocks,
            _ when path.StartsWith(DraftPaths.Features, StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.Chain, StringComparison.Ordinal) =>
                Tolerances,
            _ when path.StartsWith(DraftPaths.Counterpart, StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.Alignment, StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.OriginCheck, StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.Compensation, StringComparison.Ordinal)
                || path.StartsWith(DraftPaths.Decision, StringComparison.Ordinal) => Machine,
            _ => Gauge,
        });

    private static bool IsOfPoints(MatingDraft draft, string path)
    {
        if (path is DraftPaths.Name or DraftPaths.WorkOrder or DraftPaths.Features || OfFeature().IsMatch(path))
        {
            return true;
        }

        return Flank().Match(path) is { Success: true } match
            && int.TryParse(match.Groups["feature"].ValueSpan, NumberStyles.None, CultureInfo.InvariantCulture, out var feature)
            && feature < draft.Features.Count
            && draft.Features[feature].Kind.LeastPoints.Count > 1;
    }

    [GeneratedRegex(
        @"^\$\.features\[[0-9]+\]\.(" + FeatureDraft.NameKey + "|" + FeatureDraft.PointsKey + ")$",
        RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex OfFeature();

    [GeneratedRegex(
        @"^\$\.features\[(?<feature>[0-9]+)\]\." + FeatureDraft.PointsKey + @"\[[0-9]+\]$",
        RegexOptions.ExplicitCapture | RegexOptions.CultureInvariant,
        Timeout.Infinite)]
    private static partial Regex Flank();
}
