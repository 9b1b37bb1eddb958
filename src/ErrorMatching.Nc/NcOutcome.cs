using System.Diagnostics.CodeAnalysis;

namespace ErrorMatching.Nc;

/// <summary>Either a value or the reason why there is none.</summary>
/// <typeparam name="T">Type of the value.</typeparam>
public sealed class NcOutcome<T>
    where T : class
{
    private NcOutcome(T? value, NcRefusal? refusal) => (Value, Refusal) = (value, refusal);

    /// <summary>The value; null if refused.</summary>
    public T? Value { get; }

    /// <summary>The reason; null if there is a value.</summary>
    public NcRefusal? Refusal { get; }

    /// <summary>True if there is a value.</summary>
    [MemberNotNullWhen(true, nameof(Value))]
    [MemberNotNullWhen(false, nameof(Refusal))]
    public bool IsUsable => Refusal is null;

    /// <summary>Creates a usable outcome.</summary>
    public static implicit operator NcOutcome<T>(T value) => new(value, null);

    /// <summary>Creates a refused outcome.</summary>
    public static implicit operator NcOutcome<T>(NcRefusal refusal) => new(null, refusal);
}
