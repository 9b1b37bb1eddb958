using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// The short way for what nearly all blocks are: a straight move of plain words in a state without cycles, transforms and the like. It does what <see cref="Step"/> would do; a test holds that.
/// </content>
public sealed partial class NcInterpreter
{
    private const uint StraightLetters = LinearAxes | (1u << ('N' - 'A')) | (1u << ('F' - 'A'));

    // Runs the block whose plain words were just read; false where more than a straight move may be in it, and nothing has been done then.
    private bool TryRunStraight()
    {
        if ((_words.Present & ~_straightLetters) != 0 || _words.Repeated != 0 || _words.Functions.Length != 0 || !IsStraight())
        {
            return false;
        }

        var mode = _state.Mode;
        var codes = _words.Codes;
        if (codes.Length > 0)
        {
            var meaning = _dialect.MeaningOf(codes[0]);
            if (codes.Length > 1 || meaning is not (NcMeaning.Rapid or NcMeaning.Line) || (ListsIdleMoves && (_words.Present & LinearAxes) == 0))
            {
                return false;
            }

            Mode(meaning == NcMeaning.Rapid ? MotionKind.Rapid : MotionKind.Line);
        }
        else if (mode is not (MotionKind.Rapid or MotionKind.Line))
        {
            return false;
        }

        if (_words.Has('F'))
        {
            _state.Feed = _words.Value('F') * (_state.InchFeed && !_state.InverseTime ? MmPerInch : 1);
        }

        if ((_words.Present & LinearAxes) != 0)
        {
            if (_countsIntegers && (_words.Integers & LinearAxes) != 0)
            {
                CountIntegers();
            }

            var given = _words.Present & LinearAxes;
            var incremental = _state.Incremental ? given : 0;
            var at = _state.Position;
            var end = new Point3(Axis('X', at.X, given, incremental), Axis('Y', at.Y, given, incremental), Axis('Z', at.Z, given, incremental));
            var unknown = _state.Unknown & ~AxesOf(given & ~incremental);
            _motions.AddStraight(_block, _state, ModeFlags(), end, unknown);
            _state.Position = end;
            _state.Unknown = unknown;
        }

        return true;
    }

    // True if a straight move is nothing else: no cycle or macro waits for it, no corner and no entry of compensation, and work coordinates are those programmed.
    private bool IsStraight() =>
        _state.Cycle == NcMeaning.Unknown && _state.Form == NcMeaning.Unknown && !_hasUnknownCode && !_state.CompensationSwitched && _state.ModalRounding == 0 && _corner.Letter == 0
        && _frame is null && _transforms == Transforms.None && _cycleCall is null && _modalCycle is null && !_nextCycleIsModal && _flow is not { HasModalCall: true };
}
