#pragma once
class Servo {};
