namespace ErrorMatching.Cell;

/// <summary>An edited job that must not be saved: in the place of the one that stands there, or beside it.</summary>
/// <param name="code">Why: one of the constants here.</param>
/// <param name="message">A sentence for the one who asked: what was found and what to do.</param>
public sealed class JobEditException(string code, string message) : Exception(message)
{
    /// <summary>Something in it is wrong.</summary>
    public const string Wrong = "wrong";

    /// <summary>Somebody else changed the job since it was opened.</summary>
    public const string ChangedMeanwhile = "changed-meanwhile";

    /// <summary>Another job of the cell uses a file that would be replaced.</summary>
    public const string Shared = "shared";

    /// <summary>A saved job has the new one's name already.</summary>
    public const string NameTaken = "name-taken";

    /// <summary>No folder can have the new job's name.</summary>
    public const string NotAName = "not-a-name";

    /// <summary>Where saved jobs are kept is no folder, or a link.</summary>
    public const string NoFolder = "no-folder";

    /// <summary>A version was not kept whole: one of its files lies in another folder.</summary>
    public const string Incomplete = "incomplete";

    /// <summary>Why.</summary>
    public string Code => code;
}
