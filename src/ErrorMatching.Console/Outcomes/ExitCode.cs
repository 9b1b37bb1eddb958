namespace ErrorMatching.Console;

/// <summary>The exit codes of the process.</summary>
internal enum ExitCode
{
    /// <summary>Done.</summary>
    Done = 0,

    /// <summary>The command line or an input is wrong.</summary>
    WrongInput = 1,

    /// <summary>The inputs are readable but the result must not be used.</summary>
    Refused = 2,

    /// <summary>Something outside failed: a disk, a network.</summary>
    Outside = 3,

    /// <summary>Canceled, with no partial output (128 + SIGINT, as in shells).</summary>
    Cancelled = 130,
}
