using System.Net.Sockets;
using System.Xml;
using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Asks a control what its machine is doing. It changes nothing there.</summary>
/// <remarks>Whatever goes wrong, the answer is an unknown state with the reason: no failure can be mistaken for an idle machine.</remarks>
/// <param name="place">What is asked, for messages.</param>
/// <param name="limit">The longest that one answer may take.</param>
internal abstract class MachineStateSource(string place, TimeSpan limit)
{
    private const int MostQuoted = 200;

    /// <summary>What is asked, for messages.</summary>
    protected string Place => place;

    /// <summary>Asks once. Each call asks the control again.</summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public async Task<MachineState> AskAsync(CancellationToken cancellation)
    {
        using var late = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        late.CancelAfter(limit);
        try
        {
            return await AnswerAsync(late.Token).ConfigureAwait(false);
        }
        catch (Exception e) when (late.IsCancellationRequested && !cancellation.IsCancellationRequested
            && e is (OperationCanceledException or IOException or SocketException or HttpRequestException))
        {
            return MachineState.Unknown(Recorded.StateSlow.With(place, limit.TotalSeconds), StateCodes.Slow);
        }
        catch (StateException e)
        {
            return MachineState.Unknown(e.Statement, e.Code);
        }
        catch (XmlException e)
        {
            return MachineState.Unknown(Recorded.StateWrong.With(place, Short(e.Message)), StateCodes.Wrong);
        }
        catch (Exception e) when (e is IOException or SocketException or HttpRequestException or UnauthorizedAccessException)
        {
            return MachineState.Unknown(Recorded.StateAway.With(place, Short(e.Message)), StateCodes.Away);
        }
    }

    /// <summary>Asks once.</summary>
    /// <exception cref="StateException">The answer is not usable.</exception>
    protected abstract Task<MachineState> AnswerAsync(CancellationToken cancellation);

    /// <summary>Text from outside, short and on one line, without a point at its end.</summary>
    protected static string Short(string text) =>
        PrintedText.OneLine(text.Length > MostQuoted ? text[..MostQuoted] + "..." : text.TrimEnd('.'));

    /// <summary>The name of a program from outside, on one line. Of a long path, the end is kept: that is what names the program.</summary>
    protected static string Name(string text) => PrintedText.OneLine(text.Length > MostQuoted ? "..." + text[^MostQuoted..] : text);

    /// <summary>The exception for an answer that is not what it must be.</summary>
    /// <param name="what">What is wrong, with at most a short quotation.</param>
    protected StateException Wrong(string what) => new(StateCodes.Wrong, Recorded.StateWrong.With(place, Short(what)));
}

/// <summary>A source's answer about a machine's state is not usable.</summary>
/// <param name="code">One of <see cref="StateCodes"/>.</param>
/// <param name="message">A sentence for a setter.</param>
internal sealed class StateException(string code, Statement message) : Exception(message.Sentence)
{
    /// <summary>Stable code.</summary>
    public string Code => code;

    /// <summary>The message as it is recorded.</summary>
    public Statement Statement => message;
}

/// <summary>Stable codes for a source that does not say what its machine is doing.</summary>
internal static class StateCodes
{
    /// <summary>It does not answer.</summary>
    public const string Away = "state-away";

    /// <summary>It took too long.</summary>
    public const string Slow = "state-slow";

    /// <summary>Its answer is not what it must be.</summary>
    public const string Wrong = "state-wrong";

    /// <summary>Its answer is too old.</summary>
    public const string Stale = "state-stale";
}
