namespace ErrorMatching.Peers.Tests;

/// <summary>What a proxy does to one FTP session. It happens once; what comes after goes through.</summary>
internal sealed record FtpFault
{
    /// <summary>Cuts all connections after so many bytes of a file that is written.</summary>
    public int? CutWriting { get; init; }

    /// <summary>Cuts all connections after so many bytes of a file that is read.</summary>
    public int? CutReading { get; init; }

    /// <summary>Holds a file that is written after so many bytes for good.</summary>
    public int? StallWriting { get; init; }

    /// <summary>Holds a file that is read after so many bytes for good.</summary>
    public int? StallReading { get; init; }

    /// <summary>Changes this byte of a file that is written.</summary>
    public int? CorruptWriting { get; init; }

    /// <summary>Changes this byte of a file that is read.</summary>
    public int? CorruptReading { get; init; }

    /// <summary>Which reading is meant, from 0: the temporary file's, the last look at the old program, or the new one's.</summary>
    public int Reading { get; init; }

    /// <summary>Cuts all connections when this command comes, before the server hears of it.</summary>
    public string? CutBefore { get; init; }

    /// <summary>Cuts all connections when the server has done this command, before its last answer is heard.</summary>
    public string? CutAfter { get; init; }

    /// <summary>How many times the command of a cut passes before.</summary>
    public int Skip { get; init; }

    /// <summary>Answers this command itself; the server never hears of it.</summary>
    public (string Command, string Answer)? Instead { get; init; }

    /// <summary>Says this instead of the server's last answer to the command.</summary>
    public (string Command, string Answer)? Finally { get; init; }
}
