using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>The reduction of errors by compensation.</summary>
/// <param name="StandardDeviationPercent">Reduction of the standard deviation in percent; negative if it grew.</param>
/// <param name="ProfileIsoPercent">Reduction of the profile to ISO 1101 in percent.</param>
public sealed record SurfaceImprovement(double StandardDeviationPercent, double ProfileIsoPercent)
{
    /// <summary>Both in a sentence.</summary>
    public string Words => $"Standard deviation {Change(StandardDeviationPercent)}, profile {Change(ProfileIsoPercent)}.";

    /// <summary>Compares pieces before and after compensation; null if there is nothing to compare.</summary>
    public static SurfaceImprovement? Of(SurfaceEvaluation? before, SurfaceEvaluation? after) =>
        before is null
            || after is null
            || before.Together is not { StandardDeviationMm: > 0 and var spread, ProfileIsoMm: > 0 and var profile }
            ? null
            : new(100 * (1 - (after.Together.StandardDeviationMm / spread)), 100 * (1 - (after.Together.ProfileIsoMm / profile)));

    private static string Change(double percent) =>
        string.Create(CultureInfo.InvariantCulture, $"{(percent < 0 ? "larger" : "smaller")} by {Math.Abs(percent):0} %");
}
