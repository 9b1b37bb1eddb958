namespace ErrorMatching.Console;

/// <summary>The result of a verb: an <see cref="Answer"/> or a <see cref="Failure"/>.</summary>
internal abstract class VerbResult
{
    private protected VerbResult()
    {
    }
}
