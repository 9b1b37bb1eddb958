namespace ErrorMatching.Cell;

/// <summary>Why a transfer failed.</summary>
public enum TransportError
{
    /// <summary>The machine does not respond, or the connection broke. Worth a retry.</summary>
    Away,

    /// <summary>The machine took too long. Worth a retry.</summary>
    Slow,

    /// <summary>The login was refused.</summary>
    Login,

    /// <summary>The server's key is not the pinned one.</summary>
    WrongServer,

    /// <summary>The server denies it, or denies this name (FTP 550, 553).</summary>
    Denied,

    /// <summary>The server's disk is full (FTP 552, 452).</summary>
    Full,

    /// <summary>The server does not rename over an existing file.</summary>
    CannotReplace,

    /// <summary>The bytes read back differ from those written.</summary>
    Differs,

    /// <summary>The file at the machine exceeds the size limit.</summary>
    TooLarge,

    /// <summary>The file's name belongs to something else: a link, a pipe, a device or a folder.</summary>
    NotAFile,

    /// <summary>This computer lacks the program <c>curl</c>.</summary>
    ToolMissing,

    /// <summary>An unexpected error.</summary>
    Unknown,
}

/// <summary>A transfer that failed, or may be partly done.</summary>
/// <param name="error">Why it failed.</param>
/// <param name="message">A sentence for a setter: machine, file, the reply, what to do next. No secrets.</param>
/// <param name="cause">The underlying error; null if there is none.</param>
public sealed class TransportException(TransportError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>Why it failed.</summary>
    public TransportError Error => error;

    /// <summary>True if the same transfer may well succeed a little later.</summary>
    public bool IsWorthAnotherTry =>
        error is TransportError.Away or TransportError.Slow or TransportError.Differs or TransportError.Unknown;
}

/// <summary>Failures in a setter's terms: machine, what was being done, the reply, what to do next.</summary>
internal static class TransportFailure
{
    /// <summary>Creates the exception.</summary>
    /// <param name="error">Why it failed.</param>
    /// <param name="machine">The machine.</param>
    /// <param name="doing">What was being done, such as <c>writing P100.MPF</c>.</param>
    /// <param name="answer">The reply; no secrets.</param>
    /// <param name="cause">The underlying error; null if there is none.</param>
    public static TransportException Of(TransportError error, string machine, string doing, string answer, Exception? cause = null) =>
        new(error, $"{machine}: {doing} failed: {answer.Trim().TrimEnd('.')}. {Next(error)}", cause);

    private static string Next(TransportError error) => error switch
    {
        TransportError.Away => "Check that the machine is switched on and connected, and host, port or share in the cell's configuration.",
        TransportError.Slow => "Check the network and how busy the machine is, or raise the machine's timeout in the cell's configuration.",
        TransportError.Login => "Check the machine's user in the cell's configuration and set its password or key again.",
        TransportError.WrongServer =>
            "Nothing was sent. If the machine's key was renewed on purpose, let its administrator tell you the new one and pin that; "
                + "else somebody may stand between.",
        TransportError.Denied =>
            "Check at the machine that the login may read, write, rename and delete in this folder, and that nobody protects or runs the "
                + "program.",
        TransportError.Full => "Make room at the machine (delete programs that nobody needs, or raise the login's quota).",
        TransportError.CannotReplace => "The program there may be protected or in use: close it at the control.",
        TransportError.Differs => "Look for a bad cable or a failing disk at the machine.",
        TransportError.TooLarge => "Check at the machine what this file is.",
        TransportError.NotAFile =>
            "Nothing was opened or followed. Look at the machine who put it there, and remove it: a program is a plain file.",
        TransportError.ToolMissing => "Install it on this computer (docs/connect-a-machine.md says how) so that it is found by PATH.",
        _ => "Look into the machine's own log; if it stays, send this message to who looks after the cell.",
    };
}
