namespace ErrorMatching.Console;

/// <summary>What a verb comes to: an <see cref="Answer"/> or a <see cref="Failure"/>.</summary>
internal abstract class Outcome
{
    private protected Outcome()
    {
    }
}
