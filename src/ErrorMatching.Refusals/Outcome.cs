using System.Diagnostics.CodeAnalysis;

namespace ErrorMatching.Refusals;

/// <summary>Makes refused outcomes.</summary>
public static class Outcome
{
    /// <summary>A refused outcome with one or more reasons.</summary>
    /// <typeparam name="T">Type of the result.</typeparam>
    public static Outcome<T> Refused<T>(IReadOnlyList<Refusal> refusals)
        where T : class => refusals is { Count: > 0 }
        ? Outcome<T>.Of(refusals)
        : throw new ArgumentException("A refused outcome has at least one reason.", nameof(refusals));
}

/// <summary>A result, or the reasons why there is none. A refusal is a normal outcome, not an error.</summary>
/// <typeparam name="T">Type of the result.</typeparam>
public sealed class Outcome<T>
    where T : class
{
    private Outcome(T? result, IReadOnlyList<Refusal> refusals) => (Result, Refusals) = (result, refusals);

    /// <summary>The result; null if refused.</summary>
    public T? Result { get; }

    /// <summary>The reasons; empty if there is a result.</summary>
    public IReadOnlyList<Refusal> Refusals { get; }

    /// <summary>The first reason; null if there is a result.</summary>
    public Refusal? Refusal => IsUsable ? null : Refusals[0];

    /// <summary>True if there is a result.</summary>
    [MemberNotNullWhen(true, nameof(Result))]
    [MemberNotNullWhen(false, nameof(Refusal))]
    public bool IsUsable => Result is not null;

    /// <summary>Creates a usable outcome.</summary>
    public static implicit operator Outcome<T>(T result) =>
        new(result ?? throw new ArgumentNullException(nameof(result)), []);

    /// <summary>Creates a refused outcome.</summary>
    public static implicit operator Outcome<T>(Refusal refusal) =>
        new(null, [refusal ?? throw new ArgumentNullException(nameof(refusal))]);

    internal static Outcome<T> Of(IReadOnlyList<Refusal> refusals) => new(null, refusals);
}
