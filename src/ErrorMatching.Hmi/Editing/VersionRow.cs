using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A row for a saved version of a job.</summary>
/// <param name="Version">The version.</param>
/// <param name="Time">When it was saved.</param>
/// <param name="Restore">Loads it into the form.</param>
public sealed record VersionRow(JobVersion Version, string Time, Command Restore)
{
    private const int Digits = 8;

    /// <summary>Time, job name, user, and the first digits of the hash.</summary>
    public string Text => $"{Time} · {Version.Name} · {Version.By} · {Version.Sha256[..Digits]}…";

    /// <summary>The button's name with the version, for screen readers.</summary>
    public string Name => $"{Texts.Current["System.Restore"]} {Text}";

    public string AutomationId => "version-" + Shown.Id(Version.Entry);
}
