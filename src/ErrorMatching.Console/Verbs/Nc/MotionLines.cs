using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>Writes the motions of a program as lines of CSV, with the fields of <see cref="ShownMotion"/>. A large program has a million
/// motions, so the lines are composed in one piece of memory, without a text for each cell.</summary>
internal sealed class MotionLines(NcPath path)
{
    /// <summary>One in the last decimal that is shown.</summary>
    private const long One = 1_000_000_000;

    /// <summary>Up to this many of its last decimals a double holds a number exactly: 15 digits.</summary>
    private const double MostExact = 1e15;

    /// <summary>Room for a line without its N word: eleven numbers, two words, commas. A number above <see cref="MostExact"/> takes
    /// its own way.</summary>
    private const int Longest = 512;

    private char[] _text = new char[1 << 14];
    private int _length;

    /// <summary>Writes all motions.</summary>
    public void WriteTo(Page page)
    {
        for (var i = 0; i < path.Motions.Length; i++)
        {
            Compose(i);
            if (_length > _text.Length / 2)
            {
                page.Text(_text.AsSpan(0, _length));
                _length = 0;
            }
        }

        page.Text(_text.AsSpan(0, _length));
    }

    private void Compose(int index)
    {
        var motion = path.Motions[index];
        Reserve(Longest);
        Whole(index);
        Comma();
        Whole(motion.Block + 1);
        Comma();
        BlockNumber(motion.Block);
        Comma();
        Text(ShownMotion.KindOf(motion.Kind));
        Comma();
        Place(path.Motions.AssumedEnd(index));
        Comma();
        if (motion.IsArc)
        {
            Place(motion.Plane.Lift(motion.Center, motion.Plane.Height(motion.Start)));
        }
        else
        {
            Text(",,");
        }

        Comma();
        Text(NameOf(motion.Plane));
        Comma();
        Whole(motion.Turns);
        Comma();
        Number(motion.Feed);
        _text[_length++] = '\n';
    }

    private static string NameOf(CoordinatePlane plane) => plane switch
    {
        CoordinatePlane.XY => nameof(CoordinatePlane.XY),
        CoordinatePlane.ZX => nameof(CoordinatePlane.ZX),
        CoordinatePlane.YZ => nameof(CoordinatePlane.YZ),
        _ => plane.ToString(),
    };

    private void BlockNumber(int block)
    {
        if (path.Program.TryNumber(path.Program[block], out var token))
        {
            // Letter, spaces and digits: bytes are characters.
            Reserve(Longest + token.Length);
            foreach (var c in path.Program.Bytes.Span.Slice(token.Start, token.Length))
            {
                _text[_length++] = (char)c;
            }
        }
    }

    private void Place(Point3 place)
    {
        Number(place.X);
        Comma();
        Number(place.Y);
        Comma();
        Number(place.Z);
    }

    // The text of ShownMotion.Text: the rounded multiple of the last decimal is a whole number, whose digits are those of the number.
    private void Number(double value)
    {
        var scaled = Math.Round(value * One);
        if (!(Math.Abs(scaled) < MostExact))
        {
            var text = ShownMotion.Text(value);
            Reserve(Longest + text.Length);
            Text(text);
            return;
        }

        if (scaled < 0)
        {
            _text[_length++] = '-';
        }

        var (whole, fraction) = Math.DivRem((long)Math.Abs(scaled), One);
        Whole((int)whole);
        if (fraction == 0)
        {
            return;
        }

        // Nearly all numbers have three decimals.
        var (decimals, rest) = (9, (uint)fraction);
        if (rest % 1_000_000 == 0)
        {
            (decimals, rest) = (3, rest / 1_000_000);
        }

        for (; rest % 10 == 0; rest /= 10)
        {
            decimals--;
        }

        _text[_length] = '.';
        for (var at = _length + decimals; at > _length; at--)
        {
            _text[at] = (char)('0' + (rest % 10));
            rest /= 10;
        }

        _length += decimals + 1;
    }

    private void Whole(int value)
    {
        value.TryFormat(_text.AsSpan(_length), out var written, default, CultureInfo.InvariantCulture);
        _length += written;
    }

    private void Text(string text)
    {
        text.CopyTo(_text.AsSpan(_length));
        _length += text.Length;
    }

    private void Comma() => _text[_length++] = ',';

    private void Reserve(int length)
    {
        if (_text.Length - _length < length)
        {
            Array.Resize(ref _text, (2 * _text.Length) + length);
        }
    }
}
