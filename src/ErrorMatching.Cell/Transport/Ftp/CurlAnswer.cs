using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.Cell;

/// <summary>The result of a run of curl: its exit code (see the curl manual, EXIT CODES) and the FTP server's last reply (RFC 959,
/// 4.2).</summary>
internal sealed partial class CurlAnswer
{
    /// <summary>Makes curl write the server's last reply to standard error.</summary>
    public const string WriteOut = "%{stderr}errormatch-answer %{response_code}\\n";

    private readonly ToolResult _result;
    private readonly int _response;

    public CurlAnswer(ToolResult result)
    {
        _result = result;
        var last = Response().Matches(result.Error).LastOrDefault();
        _response = last is null ? 0 : int.Parse(last.Groups["code"].Value, NumberStyles.None, CultureInfo.InvariantCulture);
    }

    /// <summary>True if the server does not have the file or does not return it.</summary>
    public bool IsAbsent => _result.End == ToolEnd.Exited && _result.ExitCode is 78 or 19 && _response is 550 or 450 or 0;

    /// <summary>True if the server permanently refused a command, such as a rename.</summary>
    public bool IsRefusedCommand => _result.End == ToolEnd.Exited && _result.ExitCode == 21 && _response is >= 500 and < 600 and not 530;

    /// <summary>The error; null if there is none.</summary>
    public TransportError? Error => _result switch
    {
        { End: ToolEnd.TooMuch } => TransportError.TooLarge,
        { ExitCode: 0 } => null,

        // curl reports this one as a timeout too, although it comes immediately.
        { ExitCode: 28 } when _response == 421 => TransportError.Away,
        _ => OfExit(_result.ExitCode) ?? OfResponse(_response) ?? OfTransfer(_result.ExitCode),
    };

    /// <summary>The reply in words, with both codes.</summary>
    public string Text
    {
        get
        {
            if (_result.End == ToolEnd.TooMuch)
                return "it is larger than what is read";
            var said = Response().Replace(_result.Error, "").Split('\n').Select(l => l.Trim()).LastOrDefault(l => l.Length > 0) ?? "";
            said = Prefix().Replace(said, "");
            if (said.Length == 0)
                said = "no reason given";
            return _response >= 400
                ? $"the server answered {_response}{Meaning(_response)} (curl {_result.ExitCode}: {said})"
                : $"{said} (curl {_result.ExitCode})";
        }
    }

    // The error by exit code alone, regardless of earlier replies.
    private static TransportError? OfExit(int code) => code switch
    {
        1 or 2 or 4 or 48 => TransportError.ToolMissing,
        6 or 7 => TransportError.Away,
        28 => TransportError.Slow,
        51 or 60 or 83 or 90 or 91 => TransportError.WrongServer,
        64 => TransportError.WrongServer,
        63 => TransportError.TooLarge,
        _ => null,
    };

    private static TransportError? OfResponse(int response) => response switch
    {
        421 or 425 or 426 => TransportError.Away,
        430 or 530 or 331 or 332 or 532 => TransportError.Login,
        452 or 552 => TransportError.Full,
        450 or 451 => TransportError.Unknown,
        >= 500 and < 600 => TransportError.Denied,
        _ => null,
    };

    private static TransportError OfTransfer(int code) => code switch
    {
        9 => TransportError.Denied,
        67 => TransportError.Login,
        70 => TransportError.Full,
        78 => TransportError.Denied,

        // The connection broke: a missing reply, a truncated file, an aborted handshake.
        8 or 10 or 11 or 12 or 13 or 14 or 15 or 18 or 25 or 30 or 35 or 52 or 55 or 56 => TransportError.Away,
        _ => TransportError.Unknown,
    };

    private static string Meaning(int response) => response switch
    {
        421 or 425 or 426 => ", connection closed",
        430 or 530 => ", login refused",
        450 => ", file in use",
        452 or 552 => ", no room",
        550 => ", not there or not allowed",
        553 => ", name not allowed",
        _ => "",
    };

    [GeneratedRegex(@"errormatch-answer (?<code>[0-9]{3})\s*", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Response();

    [GeneratedRegex(@"\Acurl: \(\d+\) ", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Prefix();
}
