namespace ErrorMatching.Jobs;

/// <summary>A job that can be used but not edited as a draft: saving it would lose what the draft cannot say.</summary>
/// <param name="file">The job's file.</param>
/// <param name="path">Where it says it.</param>
/// <param name="what">What it says, as the end of a sentence.</param>
public sealed class DraftException(string file, string path, string what)
    : Exception($"{file}, {path}: {what} cannot be edited here and would be lost. Edit the file itself.")
{
    /// <summary>The job's file.</summary>
    public string File => file;

    /// <summary>Where it says it.</summary>
    public string Path => path;
}
