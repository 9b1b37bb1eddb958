namespace ErrorMatching.Hmi;

/// <summary>What is chosen.</summary>
public enum FileChoiceKind
{
    /// <summary>A file that is there, to be read.</summary>
    Open,

    /// <summary>A file to be written. One that is there is replaced only after a second tap.</summary>
    Save,

    /// <summary>A folder to write to. It need not be there yet.</summary>
    Folder,
}
