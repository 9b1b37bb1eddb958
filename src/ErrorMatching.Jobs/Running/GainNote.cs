using System.Globalization;

namespace ErrorMatching.Jobs;

/// <summary>The note of a report about a gain that is not the job's: the job alone would not make the same result again.</summary>
internal static class GainNote
{
    /// <summary>The note; null where the job's own gain counts.</summary>
    public static string? Of(double? given, double jobs) =>
        given is { } gain && gain != jobs ? string.Create(CultureInfo.InvariantCulture, $"A gain of {gain} took the place of the job's, which is {jobs}.") : null;
}
