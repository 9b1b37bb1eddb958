namespace ErrorMatching.Hmi;

/// <summary>What to choose.</summary>
public enum FileChoiceKind
{
    /// <summary>An existing file to read.</summary>
    Open,

    /// <summary>A file to write. An existing one is replaced only after a second tap.</summary>
    Save,

    /// <summary>A folder to write to. It need not exist yet.</summary>
    Folder,
}
