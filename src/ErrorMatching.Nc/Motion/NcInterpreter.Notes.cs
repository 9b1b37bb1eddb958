using System.Numerics;

namespace ErrorMatching.Nc;

/// <content>Numbers without a point, which count millimeters on one machine and least increments on another of the same make.</content>
public sealed partial class NcInterpreter
{
    private readonly bool _countsIntegers;
    private long _integers;
    private int _firstInteger;

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

    private NcNote[] Notes() => _integers == 0 ? [] :
    [
        new("number-without-point", _firstInteger, _integers, FormattableString.Invariant(
            $"{_integers} coordinates are written without a point, the first in {_program.NameOf(_program[_firstInteger])}. Dialect {_dialect.Name} reads them in {(_dialect.IntegersAreIncrements ? "least increments" : "millimeters or inches")}: X100 is {(_dialect.IntegersAreIncrements ? 100 / Math.Pow(10, _dialect.MetricDecimals) : 100)} mm. A machine that is set otherwise needs a dialect that says so.")),
    ];
}
