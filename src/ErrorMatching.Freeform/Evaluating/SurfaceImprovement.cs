using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>By how much errors became smaller by compensation.</summary>
/// <param name="StandardDeviationPercent">By how many percent of what it was the standard deviation became smaller; negative if it became larger.</param>
/// <param name="ProfileIsoPercent">The same of the profile by ISO 1101.</param>
public sealed record SurfaceImprovement(double StandardDeviationPercent, double ProfileIsoPercent)
{
    /// <summary>Both in a sentence.</summary>
    public string Words => $"Standard deviation {Change(StandardDeviationPercent)}, profile {Change(ProfileIsoPercent)}.";

    /// <summary>From what pieces came to before and after; null where there is nothing to compare with.</summary>
    public static SurfaceImprovement? Of(SurfaceEvaluation? before, SurfaceEvaluation? after) =>
        before is null || after is null || before.Together is not { StandardDeviationMm: > 0 and var spread, ProfileIsoMm: > 0 and var profile }
            ? null
            : new(100 * (1 - (after.Together.StandardDeviationMm / spread)), 100 * (1 - (after.Together.ProfileIsoMm / profile)));

    private static string Change(double percent) => string.Create(CultureInfo.InvariantCulture, $"{(percent < 0 ? "larger" : "smaller")} by {Math.Abs(percent):0} %");
}
