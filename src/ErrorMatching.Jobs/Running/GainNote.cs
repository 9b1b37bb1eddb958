using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>A report's note about a gain other than the job's: the job alone would not reproduce the result.</summary>
internal static class GainNote
{
    /// <summary>The note; null if the job's own gain was used.</summary>
    public static string? Of(double? given, double jobs) =>
        given is { } gain && gain != jobs
            ? string.Create(CultureInfo.InvariantCulture, $"A gain of {gain} took the place of the job's, which is {jobs}.")
            : null;
}
