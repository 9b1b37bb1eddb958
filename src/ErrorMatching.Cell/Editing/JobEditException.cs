namespace ErrorMatching.Cell;

/// <summary>Thrown if an edited job must not be saved, either in place of the existing one or as a prepared job.</summary>
/// <param name="code">The reason: one of the constants here.</param>
/// <param name="message">A sentence for the user: what was found and what to do.</param>
public sealed class JobEditException(string code, string message) : Exception(message)
{
    /// <summary>The job has a problem.</summary>
    public const string Wrong = "wrong";

    /// <summary>Another user changed the job since it was opened.</summary>
    public const string ChangedMeanwhile = "changed-meanwhile";

    /// <summary>Another job of the cell uses a file that would be replaced.</summary>
    public const string Shared = "shared";

    /// <summary>A saved job with this name already exists.</summary>
    public const string NameTaken = "name-taken";

    /// <summary>The new job's name is not a valid folder name.</summary>
    public const string NotAName = "not-a-name";

    /// <summary>The folder for saved jobs is a file or a link.</summary>
    public const string NoFolder = "no-folder";

    /// <summary>A stored version is incomplete: one of its files was in another folder.</summary>
    public const string Incomplete = "incomplete";

    /// <summary>The reason.</summary>
    public string Code => code;
}
