namespace ErrorMatching.Hmi;

/// <summary>The measurement of a counterpart that errors without compensation are told from.</summary>
/// <param name="File">The measurement's file.</param>
/// <param name="Sha256">Hash of its bytes: a file of the same name may have been another one.</param>
public sealed record KeptBase(string File, string Sha256)
{
    /// <summary>What people call it.</summary>
    public string Name => Path.GetFileName(File);
}
