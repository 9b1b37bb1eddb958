namespace ErrorMatching.Hmi;

/// <summary>The measurement of a counterpart that the errors without compensation are based on.</summary>
/// <param name="File">The measurement's file.</param>
/// <param name="Sha256">Hash of its bytes: another file may have had the same name.</param>
public sealed record KeptBase(string File, string Sha256)
{
    /// <summary>The file name without its folder.</summary>
    public string Name => Path.GetFileName(File);
}
