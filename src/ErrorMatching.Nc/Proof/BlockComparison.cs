using System.Numerics;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Compares two programs byte by byte. Skips equal runs of bytes at once. Checks each block that differs against what its
/// motion's new place can change. Reusable for many blocks.</summary>
internal sealed class BlockComparison(NcPath before, NcPath after)
{
    private const uint AxisWords = (1u << ('X' - 'A')) | (1u << ('Y' - 'A')) | (1u << ('Z' - 'A'));
    private const uint RadiusWords = (1u << ('R' - 'A')) | (1u << (NcAddress.CircleRadius - 'A'));

    private readonly BlockRemainder _original = new(before.Program);
    private readonly BlockRemainder _result = new(after.Program);

    /// <summary>The first block whose bytes, including the line end, differ from the result; the end of the range if none.</summary>
    /// <param name="first">First block of the original to compare.</param>
    /// <param name="end">End of the range.</param>
    /// <param name="linesBefore">Number of lines by which the blocks are further down in the result.</param>
    public int NextDifference(int first, int end, int linesBefore)
    {
        var (was, now) = (before.Program, after.Program);
        while (first < end)
        {
            var a = was.Bytes.Span[was[first].Start..EndOf(was, end - 1)];
            var b = now.Bytes.Span[now[first + linesBefore].Start..EndOf(now, end - 1 + linesBefore)];
            var same = a.CommonPrefixLength(b);
            // The end of a line can depend on the byte after it, so the block of the last equal byte is still in doubt.
            first = same <= was[first].FullLength ? first : was.BlockAt(was[first].Start + same - 1);
            if (!Bytes(was, first).SequenceEqual(Bytes(now, first + linesBefore)))
            {
                return first;
            }

            first++;
        }

        return end;
    }

    /// <summary>True if two blocks differ only in the values of words that the motion's new place changes, and in words that it now needs
    /// or no longer needs.</summary>
    /// <param name="motion">The motion, in both paths.</param>
    /// <param name="block">Its block in the original.</param>
    /// <param name="blockInResult">Its block in the result.</param>
    public bool SameButCoordinates(int motion, int block, int blockInResult)
    {
        var (was, now) = (before.Motions[motion], after.Motions[motion]);
        _original.Read(block);
        _result.Read(blockInResult);
        var changeable = Changeable(was);
        var changed = 0u;
        for (var rest = _original.Letters & _result.Letters & changeable; rest != 0; rest &= rest - 1)
        {
            var letter = BitOperations.TrailingZeroCount(rest);
            changed |= _original.Number(letter).SameValue(_result.Number(letter)) ? 0 : 1u << letter;
        }

        // A word is either a number in both programs or computed in both.
        for (var rest = _original.Computed & _result.Computed & changeable; rest != 0; rest &= rest - 1)
        {
            var letter = BitOperations.TrailingZeroCount(rest);
            changed |= ComputedSum.Extends(_original.ComputedValue(letter), _result.ComputedValue(letter)) ? 1u << letter : 0;
        }

        var isRadiusReplaced = was.Has(MotionFlags.ByRadius) && !now.Has(MotionFlags.ByRadius);
        var dropped = isRadiusReplaced ? RadiusWords : 0;
        var inserted = 0u;
        for (var rest = _result.Letters & ~_original.Letters & changeable; rest != 0; rest &= rest - 1)
        {
            var letter = BitOperations.TrailingZeroCount(rest);
            inserted |= IsNeeded((byte)('A' + letter), _result.Number(letter), now, isRadiusReplaced) ? 1u << letter : 0;
        }

        // Another angle of a polar end is judged by where it leads.
        var turns = was.IsToAngle && !_original.Angle.SameValue(_result.Angle);
        return _original.Without(changed, dropped, turns).SequenceEqual(_result.Without(changed, inserted, turns));
    }

    /// <summary>True if two blocks without a motion differ only in the values of coordinates.</summary>
    public bool SameButPlace(int block, int blockInResult)
    {
        _original.Read(block);
        _result.Read(blockInResult);
        return (_original.Letters & AxisWords) == (_result.Letters & AxisWords)
            && _original.Without(AxisWords, 0).SequenceEqual(_result.Without(AxisWords, 0));
    }

    private static int EndOf(NcProgram program, int block) => program[block].Start + program[block].FullLength;

    private static ReadOnlySpan<byte> Bytes(NcProgram program, int block) =>
        program.Bytes.Span.Slice(program[block].Start, program[block].FullLength);

    private static uint Changeable(in NcMotion motion)
    {
        const uint I = 1u << ('I' - 'A');
        const uint J = 1u << ('J' - 'A');
        const uint K = 1u << ('K' - 'A');
        return !motion.IsArc ? AxisWords
            : AxisWords | RadiusWords | motion.Plane switch { CoordinatePlane.ZX => K | I, CoordinatePlane.YZ => J | K, _ => I | J };
    }

    // A word may be inserted only if its axis moves now, or for a center.
    private static bool IsNeeded(byte letter, NcNumber value, in NcMotion now, bool isRadiusReplaced) => letter switch
    {
        (byte)'X' => Math.Abs(now.End.X - now.Start.X) > 1e-9,
        (byte)'Y' => Math.Abs(now.End.Y - now.Start.Y) > 1e-9,
        (byte)'Z' => Math.Abs(now.End.Z - now.Start.Z) > 1e-9,
        (byte)'R' or NcAddress.CircleRadius => false,
        _ => isRadiusReplaced || value.Digits != 0,
    };
}
