using System.Globalization;

namespace ErrorMatching.Peers.Tests;

/// <summary>Writes blocks of some topics of a random program: what all topics share.</summary>
internal abstract class ProgramPart(ProgramDraft draft, RandomNumbers random)
{
    protected ProgramDraft Draft => draft;

    // Where the position in the active coordinates is not followed here, all coordinates are said again.
    public void Restate()
    {
        draft.At = [Length(), Length(), Length()];
        draft.IsIncremental = false;
        draft.Motion = "G0";
        Block($"G90 G0 X{Number(draft.At[0])} Y{Number(draft.At[1])} Z{Number(draft.At[2])} F{Feed()}");
    }

    protected void Block(string words) => draft.Block(words);

    protected void Line(string line) => draft.Line(line);

    protected string Feed() => Number(draft.IsInch ? 1 + Below(50) : 50 + Below(2000));

    protected double Grid(double value) => Math.Round(value, draft.IsInch ? 4 : 3) + 0.0;

    protected double Length() => Grid(Uniform(-60, 60) / (draft.IsInch ? 25.4 : 1));

    protected static string Number(double value) => (value + 0.0).ToString("0.#####", CultureInfo.InvariantCulture);

    protected bool Chance(double part) => random.Chance(part);

    protected int Below(int count) => random.Below(count);

    protected double Uniform(double low, double high) => random.Uniform(low, high);

    protected T Any<T>(params ReadOnlySpan<T> choices) => choices[Below(choices.Length)];
}
