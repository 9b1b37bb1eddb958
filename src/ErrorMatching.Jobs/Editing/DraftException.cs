namespace ErrorMatching.Jobs;

/// <summary>Thrown for a usable job that cannot be edited as a draft, because saving would lose something that a draft cannot
/// represent.</summary>
/// <param name="file">The job's file.</param>
/// <param name="path">Where that is in the job.</param>
/// <param name="what">What it is, as the end of a sentence.</param>
public sealed class DraftException(string file, string path, string what)
    : Exception($"{file}, {path}: {what} cannot be edited here and would be lost. Edit the file itself.")
{
    /// <summary>The job's file.</summary>
    public string File => file;

    /// <summary>Where the unsupported content is.</summary>
    public string Path => path;
}
