using System.Numerics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Counts coordinates without a decimal point, which are millimeters on one machine and least increments on another of the same
/// make.</summary>
/// <param name="control">The control that reads them.</param>
internal sealed class IntegerWords(NcControl control)
{
    private const string Otherwise = "A machine that is set otherwise needs a dialect that says so.";

    private int _first;

    /// <summary>True if this control needs the count.</summary>
    public bool Matter { get; } = control.Dialect.NotesNumbersWithoutPoint;

    public long Count { get; private set; }

    /// <summary>Counts those of a block. Ignores zeros, which are equal in any unit, and times, counts and codes, whose unit does not
    /// depend on a point.</summary>
    public void CountIn(int block)
    {
        var words = control.Words;
        for (var letters = words.Integers & words.Present & control.Values.LengthLetters; letters != 0; letters &= letters - 1)
        {
            if (words.Value((byte)('A' + BitOperations.TrailingZeroCount(letters))) != 0)
            {
                _first = Count == 0 ? block : _first;
                Count++;
            }
        }
    }

    /// <summary>Adds those of blocks that another run executed, whose first one needs no note.</summary>
    public void Add(long count) => Count += count;

    /// <summary>Continues with the counts of another run.</summary>
    public void Join(IntegerWords ahead) => (_first, Count) = (Count > 0 ? _first : ahead._first, Count + ahead.Count);

    /// <summary>The notes about them.</summary>
    public IEnumerable<NcNote> Notes()
    {
        if (Count > 0)
        {
            var (dialect, program) = (control.Dialect, control.Run.Program);
            var counts = dialect.IntegersAreIncrements;
            var unit = counts ? "least increments" : "millimeters or inches";
            var hundred = counts ? 100 / Elementary.Pow(10, dialect.MetricDecimals) : 100;
            var reading = FormattableString.Invariant($"Dialect {dialect.Name} reads them in {unit}: X100 is {hundred} mm.");
            yield return new("number-without-point", _first, Count, FormattableString.Invariant(
                $"{Count} coordinates are written without a point, the first in {program.NameOf(program[_first])}. {reading} {Otherwise}"));
        }
    }
}
