using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

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
