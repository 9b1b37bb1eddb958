using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A saved version of a job, as a row.</summary>
/// <param name="Version">The version.</param>
/// <param name="Time">When it was saved.</param>
/// <param name="Restore">Brings it back into the form.</param>
public sealed record VersionRow(JobVersion Version, string Time, Command Restore)
{
    private const int Digits = 8;

    /// <summary>When, what it was called, by whom, and the first digits of its hash.</summary>
    public string Text => $"{Time} · {Version.Name} · {Version.By} · {Version.Sha256[..Digits]}…";

    /// <summary>What the button does, with which version, for those who do not see the row.</summary>
    public string Name => $"{Texts.Current["System.Restore"]} {Text}";

    /// <summary>By which it is found on the screen.</summary>
    public string AutomationId => "version-" + Shown.Id(Version.Entry);
}
