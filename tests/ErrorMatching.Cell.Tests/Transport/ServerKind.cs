namespace ErrorMatching.Cell.Tests;

/// <summary>What a machine's server does with a file that is renamed to a name that something has.</summary>
public enum ServerKind
{
    /// <summary>Lets the two change their names, as a folder does.</summary>
    Exchanges,

    /// <summary>Puts it in the other's place, as most FTP servers do.</summary>
    Replaces,

    /// <summary>Refuses.</summary>
    Refuses,
}
