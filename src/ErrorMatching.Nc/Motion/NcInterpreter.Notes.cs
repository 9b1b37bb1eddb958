using System.Numerics;

namespace ErrorMatching.Nc;

/// <content>
/// What every result must say of how the program was read: what the control does that is not followed, and numbers without a point, which count millimeters on one
/// machine and least increments on another of the same make.
/// </content>
public sealed partial class NcInterpreter
{
    private readonly List<NcNote> _notes = [];
    private readonly bool _countsIntegers;
    private long _integers;
    private int _firstInteger;

    // Kept where it is first met, and counted from there on.
    private void Note(string code, string message)
    {
        var known = _notes.FindIndex(n => n.Code == code);
        if (known < 0)
        {
            _notes.Add(new(code, _block, 1, message));
        }
        else
        {
            _notes[known] = _notes[known] with { Count = _notes[known].Count + 1 };
        }
    }

    // Zero is zero in any unit; times, counts and codes have no unit that a point changes.
    private void CountIntegers()
    {
        for (var letters = _words.Integers & _words.Present & _lengthLetters; letters != 0; letters &= letters - 1)
        {
            if (_words.Value((byte)('A' + BitOperations.TrailingZeroCount(letters))) != 0)
            {
                _firstInteger = _integers == 0 ? _block : _firstInteger;
                _integers++;
            }
        }
    }

    private IReadOnlyList<NcNote> Notes() => [.. _notes.Concat(_flow?.Notes ?? []).Concat(NumbersWithoutPoint()).OrderBy(n => n.Block)];

    private NcNote[] NumbersWithoutPoint() => _integers == 0 ? [] :
    [
        new("number-without-point", _firstInteger, _integers, FormattableString.Invariant(
            $"{_integers} coordinates are written without a point, the first in {_program.NameOf(_program[_firstInteger])}. Dialect {_dialect.Name} reads them in {(_dialect.IntegersAreIncrements ? "least increments" : "millimeters or inches")}: X100 is {(_dialect.IntegersAreIncrements ? 100 / Math.Pow(10, _dialect.MetricDecimals) : 100)} mm. A machine that is set otherwise needs a dialect that says so.")),
    ];
}
