namespace ErrorMatching.Cell.Tests;

/// <summary>A machine's state as a test says it.</summary>
/// <param name="Say">Asked each time.</param>
internal sealed record ToldState(Func<MachineState> Say) : StateSettings
{
    public override string Address => "the test";

    internal override MachineStateSource Open(TimeProvider clock) => new Source(this);

    public static MachineState Of(MachineActivity activity, params string[] programs) => new(activity, programs, null);

    private sealed class Source(ToldState told) : MachineStateSource(told.Address, told.Timeout)
    {
        protected override Task<MachineState> AnswerAsync(CancellationToken cancellation) => Task.FromResult(told.Say());
    }
}
