using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A saved version of a job, as a row.</summary>
/// <param name="Version">The version.</param>
/// <param name="Time">When it was saved.</param>
public sealed record VersionRow(JobVersion Version, string Time)
{
    private const int Digits = 8;

    /// <summary>When, by whom, and the first digits of its hash.</summary>
    public string Text => $"{Time} · {Version.By} · {Version.Sha256[..Digits]}…";

    /// <summary>By which it is found on the screen.</summary>
    public string AutomationId => "version-" + Shown.Id(Version.Entry);
}
