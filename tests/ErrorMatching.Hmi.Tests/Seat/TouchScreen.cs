using System.Diagnostics;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A real X server with a touch screen that a test puts fingers on: Xorg with a screen in memory, and X.Org's input driver for
/// tests, which receives fingers through a socket.</summary>
/// <remarks>It takes no console, no keyboard and no mouse of the computer. It ends with the last program that is connected to it.</remarks>
internal sealed class TouchScreen
{
    public const int Width = 1024, Height = 768;

    private const string Program = "/usr/lib/xorg/Xorg", Modules = "/usr/lib/xorg/modules";
    private const int Version = 0, Sync = 1, Touch = 6, Axes = 64;

    // The driver's axes have 65536 steps.
    private const double Steps = 65536;

    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(1);
    private readonly Socket _fingers;
    private readonly HashSet<int> _down = [];
    private bool _isMoving;

    private TouchScreen(string display, Socket fingers) => (Display, _fingers) = (display, fingers);

    /// <summary>True if all that it needs is installed.</summary>
    public static bool IsInstalled { get; } = File.Exists(Program) && File.Exists(Modules + "/drivers/dummy_drv.so")
        && File.Exists(Modules + "/input/inputtest_drv.so");

    /// <summary>The name of its display.</summary>
    public string Display { get; }

    /// <summary>Starts one, with a number of its own.</summary>
    public static TouchScreen Start()
    {
        using var folder = new TemporaryFolder();
        var configuration = folder.File(
            "xorg.conf",
            $"""
            Section "ServerFlags"
                Option "AutoAddDevices" "false"
                Option "AutoAddGPU" "false"
            EndSection
            Section "Device"
                Identifier "memory"
                Driver "dummy"
            EndSection
            Section "Monitor"
                Identifier "monitor"
                HorizSync 5-1000
                VertRefresh 5-200
            EndSection
            Section "Screen"
                Identifier "screen"
                Device "memory"
                Monitor "monitor"
                DefaultDepth 24
                SubSection "Display"
                    Virtual {Width} {Height}
                EndSubSection
            EndSection
            Section "InputDevice"
                Identifier "fingers"
                Driver "inputtest"
                Option "DeviceType" "Touch"
                Option "SocketPath" "{folder["fingers"]}"
            EndSection
            Section "ServerLayout"
                Identifier "layout"
                Screen "screen"
                InputDevice "fingers" "SendCoreEvents"
            EndSection
            """);

        // On a seat of its own, it leaves the consoles alone.
        string[] arguments =
        [
            "-displayfd", "1", "-config", configuration, "-logfile", folder["log"], "-seat", "seat-of-tests", "-novtswitch", "-sharevts",
            "-terminate", "-nolisten", "tcp"
        ];
        using var process = Process.Start(
            new ProcessStartInfo(Program, arguments)
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                UseShellExecute = false
            })!;
        var display = process.StandardOutput.ReadLine()
            ?? throw new InvalidOperationException($"Xorg does not start: {process.StandardError.ReadToEnd()}");
        var fingers = new Socket(AddressFamily.Unix, SocketType.Stream, ProtocolType.Unspecified)
        {
            ReceiveTimeout = (int)Patience.TotalMilliseconds
        };
        fingers.Connect(new UnixDomainSocketEndPoint(folder["fingers"]));
        var screen = new TouchScreen(":" + display, fingers);
        screen.Send(BitConverter.GetBytes(0x0001_0001), Version);
        screen.Answer(Version, 12);
        return screen;
    }

    /// <summary>Puts a finger on the screen.</summary>
    public TouchScreen Begin(int finger, double x, double y) => Put(finger, XInput.TouchBegin, x, y);

    /// <summary>Moves a finger.</summary>
    public TouchScreen Move(int finger, double x, double y) => Put(finger, XInput.TouchUpdate, x, y);

    /// <summary>Lifts a finger.</summary>
    public TouchScreen End(int finger, double x, double y) => Put(finger, XInput.TouchEnd, x, y);

    /// <summary>Lifts the fingers that a test left there.</summary>
    public void LiftAll()
    {
        foreach (var finger in _down.ToArray())
        {
            End(finger, 0, 0);
        }
    }

    /// <summary>Waits until the server has processed all this, and then until it has sent the station what follows from it.</summary>
    public void Arrive()
    {
        // Asked before the first finger, the driver never answers.
        if (_isMoving)
        {
            _isMoving = false;
            Send([], Sync);
            Answer(Sync, 8);
        }

        _ = Xlib.XSync(X11Connection.Display, 0);
        X11Connection.DrainLater();
    }

    // Two valuators with values, of 64 that have room, and room for others that are not accelerated.
    private TouchScreen Put(int finger, int kind, double x, double y)
    {
        Span<byte> body = stackalloc byte[8 + 4 + 8 + 4 + (2 * Axes * sizeof(double))];
        body.Clear();
        MemoryMarshal.Write(body, finger);
        MemoryMarshal.Write(body[4..], kind);
        body[12] = 3;
        MemoryMarshal.Write(body[24..], x * Steps / Width);
        MemoryMarshal.Write(body[32..], y * Steps / Height);
        Send(body, Touch);
        _ = kind == XInput.TouchEnd ? _down.Remove(finger) : _down.Add(finger);
        _isMoving = true;
        return this;
    }

    private void Send(ReadOnlySpan<byte> body, int type) =>
        _fingers.Send([.. BitConverter.GetBytes(8 + body.Length), .. BitConverter.GetBytes(type), .. body]);

    private void Answer(int type, int length)
    {
        var answer = new byte[length];
        for (var read = 0; read < length;)
        {
            var more = _fingers.Receive(answer.AsSpan(read));
            Assert.NotEqual(0, more);
            read += more;
        }

        Assert.Equal((length, type), (BitConverter.ToInt32(answer, 0), BitConverter.ToInt32(answer, 4)));
    }
}
