using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Writes moves as blocks directly to bytes: words only if they change, numbers as exact decimals.</summary>
internal sealed class MoveWriter
{
    private const int BlockBytes = 128;

    private readonly Stream _stream;
    private readonly byte[] _buffer = new byte[64 * 1024];
    private readonly int _decimals;
    private readonly double _scale;
    private readonly double _tipBelow;
    private readonly byte[] _feed;
    private long _x = long.MinValue;
    private long _y = long.MinValue;
    private long _z;
    private bool _rapid = true;
    private bool _fed;
    private int _count;

    /// <param name="stream">The output.</param>
    /// <param name="decimals">Decimals of coordinates.</param>
    /// <param name="tipBelowMm">Distance of the programmed point below the center.</param>
    /// <param name="feed">The feed as written.</param>
    /// <param name="travelCenterZ">Height of the tool at the start, with G0 active.</param>
    public MoveWriter(Stream stream, int decimals, double tipBelowMm, byte[] feed, double travelCenterZ)
    {
        (_stream, _decimals, _tipBelow, _feed) = (stream, decimals, tipBelowMm, feed);
        _scale = Elementary.Pow(10, decimals);
        _z = Steps(travelCenterZ - tipBelowMm);
    }

    public void Write(in ToolMove move)
    {
        if (_count > _buffer.Length - BlockBytes)
        {
            Flush();
        }

        var (x, y, z) = (Steps(move.Center.X), Steps(move.Center.Y), Steps(move.Center.Z - _tipBelow));
        if (x == _x && y == _y && z == _z)
        {
            return;
        }

        var start = _count;
        if (move.IsRapid != _rapid)
        {
            _buffer[_count++] = (byte)'G';
            _buffer[_count++] = move.IsRapid ? (byte)'0' : (byte)'1';
            _rapid = move.IsRapid;
        }

        Word('X', x, ref _x, start);
        Word('Y', y, ref _y, start);
        Word('Z', z, ref _z, start);
        if (!move.IsRapid && !_fed)
        {
            _buffer[_count++] = (byte)' ';
            _feed.CopyTo(_buffer, _count);
            (_count, _fed) = (_count + _feed.Length, true);
        }

        _buffer[_count++] = (byte)'\n';
    }

    public void Flush()
    {
        _stream.Write(_buffer, 0, _count);
        _count = 0;
    }

    private long Steps(double mm) => double.ConvertToIntegerNative<long>(Math.Round(mm * _scale));

    private void Word(char letter, long steps, ref long last, int start)
    {
        if (steps == last)
        {
            return;
        }

        last = steps;
        if (_count > start)
        {
            _buffer[_count++] = (byte)' ';
        }

        _buffer[_count++] = (byte)letter;
        if (steps < 0)
        {
            _buffer[_count++] = (byte)'-';
        }

        // From the last digit to the first: the decimals, the point, the integer part.
        var left = (ulong)Math.Abs(steps);
        var digits = _decimals + 2;
        for (var bound = left; bound >= TwoDigits; bound /= 10)
        {
            digits++;
        }

        var at = _count + digits;
        _count = at;
        for (var i = 0; i < _decimals; i++)
        {
            (left, var digit) = Math.DivRem(left, 10);
            _buffer[--at] = (byte)('0' + digit);
        }

        _buffer[--at] = (byte)'.';
        do
        {
            (left, var digit) = Math.DivRem(left, 10);
            _buffer[--at] = (byte)('0' + digit);
        }
        while (left > 0);
    }

    // The first number whose integer part has two digits.
    private ulong TwoDigits => (ulong)_scale * 10;
}
