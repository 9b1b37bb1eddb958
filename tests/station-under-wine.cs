#:property PublishAot=false
#:property AllowUnsafeBlocks=true
using System.Globalization;
using System.Runtime.InteropServices;

// Does to a window on Windows what xdotool cannot: puts fingers on it, and moves it to a monitor with another scaling. It sends the
// messages that Windows sends then; tests/station-under-wine runs it beside the station.
//   TITLE tap X Y              one finger
//   TITLE pinch X Y FROM TO    two fingers left and right of a place; what is between them grows or shrinks from FROM to TO pixels
//   TITLE dpi VALUE            another scaling, such as 144
//   TITLE display              the display came back, as after remote desktop, and a setting of the system has changed
//   TITLE hold                 holds the clipboard until a line comes in, as another program does, and says when it begins
//   TITLE end                  the session of Windows ends
//   TITLE read                 reads the window as a screen reader does: prints of each element its kind, whether it has the focus (1),
//                              and its name
var window = FindWindow(null, args[0]);
if (window == 0)
{
    Console.Error.WriteLine($"There is no window {args[0]}.");
    return 1;
}

var numbers = args[2..].Select(a => int.Parse(a, CultureInfo.InvariantCulture)).ToArray();
switch (args[1])
{
    case "tap":
        Finger(Down, 1, numbers[0], numbers[1]);
        Finger(Up, 1, numbers[0], numbers[1]);
        return 0;
    case "pinch":
        const int steps = 10;
        var (x, y, from, to) = (numbers[0], numbers[1], numbers[2], numbers[3]);
        Both(Down, from);
        for (var i = 1; i <= steps; i++)
        {
            Both(Update, from + ((to - from) * i / steps));
        }

        Both(Up, to);
        return 0;

        void Both(uint message, int apart)
        {
            Finger(message, 1, x - (apart / 2), y);
            Finger(message, 2, x + (apart / 2), y);
        }

    case "dpi":
        ChangeDpi(numbers[0]);
        return 0;
    case "display":
        _ = SendMessage(window, DisplayChanged, 32, (1000 << 16) | 1600);
        _ = SendMessage(window, SettingChanged, 0, 0);
        return 0;
    case "hold":
        if (OpenClipboard(0) == 0)
        {
            throw new InvalidOperationException("Another program holds the clipboard.");
        }

        Console.WriteLine("held");
        _ = Console.ReadLine();
        _ = CloseClipboard();
        return 0;
    case "end":
        if (SendMessage(window, MaySessionEnd, 0, 0) == 0)
        {
            Console.Error.WriteLine("The window does not let the session end.");
            return 1;
        }

        _ = SendMessage(window, SessionEnds, 1, 0);
        return 0;
    case "read":
        Console.OutputEncoding = System.Text.Encoding.UTF8;
        Check(UiaNodeFromHandle(window, out var node));
        Read(node, 0);
        return 0;
    default:
        Console.Error.WriteLine($"{args[1]} is unknown.");
        return 1;
}

void Finger(uint message, int finger, int x, int y)
{
    // In contact, unless it is lifted; places are those of the screen.
    var flags = message == Up ? 0 : 4;

    // It returns when the window has taken the message.
    _ = SendMessage(window, message, (flags << 16) | finger, (y << 16) | x);
}

// The message refers to a rectangle, which has to be in the other process.
unsafe void ChangeDpi(int dpi)
{
    Rect rect;
    uint id;
    _ = GetWindowRect(window, &rect);
    _ = GetWindowThreadProcessId(window, &id);
    var process = OpenProcess(AllAccess, 0, id);
    var memory = VirtualAllocEx(process, 0, (nuint)sizeof(Rect), Commit, ReadWrite);
    if (memory == 0 || WriteProcessMemory(process, memory, &rect, (nuint)sizeof(Rect), 0) == 0)
    {
        throw new InvalidOperationException("The other process gives no memory.");
    }

    _ = SendMessage(window, DpiChanged, (dpi << 16) | dpi, memory);
    _ = CloseHandle(process);
}

void Read(nint node, int depth)
{
    Console.WriteLine($"{new string(' ', depth)}{Property(node, ControlType)} {Property(node, HasFocus)} {Property(node, Name)}");
    for (var child = Go(node, FirstChild); child != 0; child = Go(child, NextSibling))
    {
        Read(child, depth + 1);
    }
}

object? Property(nint node, int property)
{
    Check(UiaGetPropertyValue(node, property, out var value));
    return value is bool isTrue ? Convert.ToInt32(isTrue) : value;
}

// All elements count, and nothing is wanted of them but themselves.
unsafe nint Go(nint node, int direction)
{
    var all = 0;
    var request = new Request { Condition = &all, Scope = 1, Mode = 1 };
    nint found, structure, next;
    Check(UiaNavigate(node, direction, &all, &request, &found, &structure));
    Marshal.FreeBSTR(structure);
    if (found == 0)
    {
        return 0;
    }

    var at = stackalloc int[2];
    var value = stackalloc byte[24];
    Check(SafeArrayGetElement(found, at, value));
    Check(UiaHUiaNodeFromVariant(value, &next));
    return next;
}

void Check(int result) => Marshal.ThrowExceptionForHR(result);

internal partial class Program
{
    private const int ControlType = 30003, Name = 30005, HasFocus = 30008, NextSibling = 1, FirstChild = 3;
    private const uint MaySessionEnd = 0x11, SessionEnds = 0x16, SettingChanged = 0x1A, DisplayChanged = 0x7E;
    private const uint Update = 0x245, Down = 0x246, Up = 0x247, DpiChanged = 0x2E0, AllAccess = 0x1FFFFF, Commit = 0x3000, ReadWrite = 4;

    [DllImport("user32", EntryPoint = "FindWindowW", CharSet = CharSet.Unicode)]
    private static extern nint FindWindow(string? kind, string title);

    [DllImport("user32", EntryPoint = "SendMessageW")] private static extern nint SendMessage(nint window, uint message, nint w, nint l);
    [DllImport("user32")] private static extern int OpenClipboard(nint window);
    [DllImport("user32")] private static extern int CloseClipboard();
    [DllImport("user32")] private static extern unsafe int GetWindowRect(nint window, Rect* rect);
    [DllImport("user32")] private static extern unsafe uint GetWindowThreadProcessId(nint window, uint* process);
    [DllImport("kernel32")] private static extern nint OpenProcess(uint access, int inherits, uint process);
    [DllImport("kernel32")] private static extern nint VirtualAllocEx(nint process, nint at, nuint bytes, uint kind, uint protection);
    [DllImport("kernel32")]
    private static extern unsafe int WriteProcessMemory(nint process, nint at, Rect* from, nuint bytes, nint written);
    [DllImport("kernel32")] private static extern int CloseHandle(nint handle);
    [DllImport("uiautomationcore")] private static extern int UiaNodeFromHandle(nint window, out nint node);
    [DllImport("uiautomationcore")]
    private static extern int UiaGetPropertyValue(nint node, int property, [MarshalAs(UnmanagedType.Struct)] out object? value);
    [DllImport("uiautomationcore")]
    private static extern unsafe int UiaNavigate(nint node, int direction, int* condition, Request* request, nint* found, nint* structure);
    [DllImport("uiautomationcore")] private static extern unsafe int UiaHUiaNodeFromVariant(byte* value, nint* node);
    [DllImport("oleaut32")] private static extern unsafe int SafeArrayGetElement(nint array, int* at, byte* value);

    // UiaCacheRequest.
    private unsafe struct Request
    {
        public int* Condition;
        public int Scope;
        public nint Properties;
        public int PropertyCount;
        public nint Patterns;
        public int PatternCount, Mode;
    }

    private struct Rect
    {
        public int Left, Top, Right, Bottom;
    }
}
