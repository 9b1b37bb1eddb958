using System.Globalization;
using System.Xml;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Reads an MTConnectStreams document (MTConnect Part 3, versions 1.0 to 2.x): what the controller or its paths execute.</summary>
/// <remarks>Names of elements are compared without their namespace, which differs from version to version. What is not known is
/// unknown: a machine is idle only if every path says so.</remarks>
internal sealed class MtConnectStreams(MtConnectSettings settings, string place, Func<string, StateException> wrong)
{
    private const string Unavailable = "UNAVAILABLE";
    private const int MostDepth = 32;
    private const int MostItems = 200;
    private static readonly string[] Alarms = ["SYSTEM", "LOGIC_PROGRAM", "MOTION_PROGRAM"];
    private readonly List<Device> _devices = [];
    private Device? _device;

    /// <summary>Reads the document.</summary>
    /// <exception cref="XmlException">It is not well-formed, or declares a document type.</exception>
    /// <exception cref="StateException">It does not have one device that says what it executes.</exception>
    public MachineState Read(ReadOnlyMemory<byte> document, CancellationToken cancellation)
    {
        using var nodes = new XmlNodes(document);
        var xml = nodes.Xml;
        while (nodes.Read() && xml.NodeType != XmlNodeType.Element)
        {
        }

        if (xml.LocalName == "MTConnectError")
            throw wrong(ErrorOf(nodes));
        if (xml.LocalName != "MTConnectStreams")
            throw wrong($"the element {xml.LocalName} instead of MTConnectStreams");
        while (nodes.Read())
        {
            cancellation.ThrowIfCancellationRequested();
            if (xml.Depth > MostDepth)
                throw wrong("elements within elements without end");
            if (xml.NodeType == XmlNodeType.Element)
                Take(xml);
        }

        var devices = _devices.Where(d => !d.IsAgent && IsWanted(d)).ToArray();
        return devices switch
        {
            [var only] => StateOf(only),
            [] => throw wrong(settings.Device is { } name ? $"no device {name}" : "no device"),
            _ => throw wrong($"several devices ({string.Join(", ", devices.Take(5).Select(d => d.Name))}): name one in the configuration"),
        };
    }

    private bool IsWanted(Device device) => settings.Device is not { } name || device.Name == name || device.Uuid == name;

    private static string ErrorOf(XmlNodes nodes)
    {
        var xml = nodes.Xml;
        while (nodes.Read())
        {
            if (xml is { NodeType: XmlNodeType.Element, LocalName: "Error" })
                return $"{xml.GetAttribute("errorCode")}: {xml.ReadElementContentAsString()}";
        }

        return "MTConnectError";
    }

    private void Take(XmlReader xml)
    {
        if (xml.LocalName == "DeviceStream")
        {
            _devices.Add(_device = new(xml.GetAttribute("name") ?? "", xml.GetAttribute("uuid") ?? ""));
        }
        else if (_device is null)
        {
            // The header.
        }
        else if (xml.LocalName == "ComponentStream")
        {
            _device.Component = xml.GetAttribute("componentId") ?? "";
            _device.IsAgent |= xml.GetAttribute("component") == "Agent";
        }
        else if (xml.LocalName == "Fault" && Alarms.Contains(xml.GetAttribute("type"), StringComparer.Ordinal))
        {
            _device.IsAlarm = true;
        }
        else if (xml.LocalName is "Execution" or "Program" or "ControllerMode" or "EmergencyStop" or "Availability")
        {
            TakeValue(_device, xml);
        }
    }

    private void TakeValue(Device device, XmlReader xml)
    {
        if (device.Items.Count == MostItems)
            throw wrong("too many programs and paths");
        var (name, time) = (xml.LocalName, xml.GetAttribute("timestamp"));
        using var inside = xml.ReadSubtree();
        inside.Read();
        device.Items.Add((device.Component, name, inside.ReadElementContentAsString().Trim(), time));
    }

    private MachineState StateOf(Device device)
    {
        var items = device.Items;
        if (items.Exists(i => i is { Name: "Availability", Value: Unavailable }))
            return MachineState.Unknown(Recorded.StateUnavailable.With(place, "Availability"));
        var executions = items.Where(i => i.Name == "Execution").ToArray();
        if (executions.Length == 0)
            throw wrong("no Execution");
        if (executions.Any(e => e.Value is Unavailable or ""))
            return MachineState.Unknown(Recorded.StateUnavailable.With(place, "Execution"));

        var activities = executions.Select(e => (e.Component, Activity: ActivityOf(e.Component, e.Value, items))).ToArray();
        var isAlarm = device.IsAlarm || items.Exists(i => i is { Name: "EmergencyStop", Value: "TRIGGERED" });
        var activity = isAlarm ? MachineActivity.Alarm : activities.Max(a => a.Activity);
        DateTimeOffset? since = executions.Select(e => TimeOf(e.Time)).Max();

        // Programs of paths that are idle are only selected there. One that belongs to no path concerns all.
        var idle = isAlarm ? [] : activities.Where(a => a.Activity == MachineActivity.Idle).Select(a => a.Component).ToArray();
        var programs = items.Where(i => i.Name == "Program" && !idle.Contains(i.Component, StringComparer.Ordinal)).ToArray();
        var isSaid = programs.Length > 0 && programs.All(p => p.Value is not ("" or Unavailable));
        return new(activity, isSaid ? [.. programs.Select(p => p.Value).Distinct(StringComparer.Ordinal)] : null, since);
    }

    // The words of MTConnect Part 2, EXECUTION. A program that is being edited is in somebody's hands.
    private MachineActivity ActivityOf(
        string component, string execution, List<(string Component, string Name, string Value, string?)> items) =>
        execution switch
        {
            "READY" or "PROGRAM_COMPLETED" => items.Exists(i => i.Component == component && i is { Name: "ControllerMode", Value: "EDIT" })
                ? MachineActivity.Held
                : MachineActivity.Idle,
            "ACTIVE" or "WAIT" => MachineActivity.Running,
            "STOPPED" => settings.StoppedIsIdle ? MachineActivity.Idle : MachineActivity.Held,
            "INTERRUPTED" or "FEED_HOLD" or "PROGRAM_STOPPED" or "OPTIONAL_STOP" or "PROGRAM_OPTIONAL_STOP" => MachineActivity.Held,
            _ => throw wrong($"the execution {execution}"),
        };

    private static DateTimeOffset? TimeOf(string? text) =>
        DateTimeOffset.TryParse(text, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal, out var time) ? time : null;

    private sealed class Device(string name, string uuid)
    {
        public string Name => name;

        public string Uuid => uuid;

        public string Component { get; set; } = "";

        public bool IsAgent { get; set; }

        public bool IsAlarm { get; set; }

        public List<(string Component, string Name, string Value, string? Time)> Items { get; } = [];
    }
}
