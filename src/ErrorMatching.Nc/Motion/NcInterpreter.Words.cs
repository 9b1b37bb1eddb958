namespace ErrorMatching.Nc;

/// <content>Words that stand in the way of knowing, or of changing, what a block does.</content>
public sealed partial class NcInterpreter
{
    private const int LongestShown = 60;

    private MotionFlags ReadObstacles()
    {
        var flags = MotionFlags.None;
        if (_words.Statements.Count > 0)
        {
            flags |= ReadStatements();
        }

        if (_words.Invalid.Length > 0)
        {
            flags |= UnknownWord(TextOf(_words.Invalid));
            Forget();
        }

        if (_words.Semicolon.Length > 1)
        {
            flags |= ReadSemicolon();
        }

        var given = _words.Present | _words.Computed;
        if ((given & _unknownLetters) != 0)
        {
            for (var letter = 'A'; letter <= 'Z'; letter++)
            {
                flags |= (given & _unknownLetters & BlockWords.Bit(letter)) != 0 ? UnknownWord(letter.ToString()) : MotionFlags.None;
            }
        }

        if ((_words.Computed & (BlockWords.Bit('G') | BlockWords.Bit('M'))) != 0)
        {
            Forget();
        }

        if ((_words.Repeated & GeometryWords) != 0)
        {
            flags |= Problem("repeated-word", "A coordinate stands twice in the block; which one counts depends on the control.", MotionFlags.UnknownWord);
        }

        flags |= (_words.Computed & GeometryWords) != 0 ? MotionFlags.Expression : MotionFlags.None;
        flags |= _words.Corner != 0 ? MotionFlags.CornerWord : MotionFlags.None;
        _state.ModalRounding = _words.Corner == 'M' ? CornerLength() : _state.ModalRounding;
        return flags | ((given & _otherAxes) != 0 ? MotionFlags.OtherAxis : MotionFlags.None);
    }

    private MotionFlags UnknownWord(string what) => Problem("unknown-word", $"\"{what}\" is not known to the dialect {_dialect.Name}.", MotionFlags.UnknownWord);

    // The beginning of a word that is longer than anybody wants to read.
    private string TextOf(NcToken token) => token.Length <= LongestShown
        ? NcText.Decode(_text.Bytes.Span.Slice(token.Start, token.Length))
        : NcText.Decode(_text.Bytes.Span.Slice(token.Start, LongestShown)) + "...";
}
